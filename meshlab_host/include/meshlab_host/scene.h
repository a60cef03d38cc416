// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_host/meshlab_api.h"

#if MESHLAB_API < 2022
#include <common/ml_shared_data_context.h>
#else
#include <common/ml_shared_data_context/ml_scene_gl_shared_data_context.h>
#endif

namespace meshlab_host {

/// MeshLab's GUI state for the document of `mesh`: the document and its layers' render settings.
/// Null without a GUI. Decorations are not handed it.
MLSceneGLSharedDataContext* sceneOf(const MeshModel& mesh);

/// For a document that exists.
MLSceneGLSharedDataContext* sceneOf(const MeshDocument& document);

}  // namespace meshlab_host
