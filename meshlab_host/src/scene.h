// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_host/meshlab_api.h"

#if MESHLAB_API < 2022
#include <common/ml_shared_data_context.h>
#else
#include <common/ml_shared_data_context/ml_scene_gl_shared_data_context.h>
#endif

namespace meshlab_host {

/// What MeshLab's GUI keeps for the document of `mesh`: the document and the render settings of its
/// layers. Null in programs without a GUI. Decorations are not handed it.
MLSceneGLSharedDataContext* sceneOf(const MeshModel& mesh);

/// The same of a document that is there.
MLSceneGLSharedDataContext* sceneOf(const MeshDocument& document);

}  // namespace meshlab_host
