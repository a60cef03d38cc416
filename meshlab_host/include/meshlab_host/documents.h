// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

/// MeshLab's GUI state for the document of `mesh`: the document and its layers' render settings.
/// Null without a GUI. MeshLab does not pass it to decorations.
MLSceneGLSharedDataContext* scene_of(const MeshModel& mesh);

/// The same for a document, which has to exist.
MLSceneGLSharedDataContext* scene_of(const MeshDocument& document);

/// The document of `mesh`. Null if there is none, as without a GUI. GUI thread only.
MeshDocument* document_of(const MeshModel& mesh);

std::vector<const MeshModel*> layers_of(const MeshDocument& document);

/// Ids of all layers of the document, or of those that MeshLab shows, ascending.
std::vector<int> layer_ids(const MeshDocument& document, bool only_shown = false);

/// Shows text in the corner of the view until the next redraw. `mesh` is shown only if two boxes
/// have the same title. GUI thread only, while drawing.
void write_on_view(GLLogStream& log, const QString& title, const QString& mesh,
                   const QString& text);

/// Replaces the parameters in MeshLab's record of a filter that its dialog has run, once that
/// exists, so that saved scripts have them. Call it last in the filter, since progress runs
/// MeshLab's events.
void record_as(const QString& filter, const RichParameterList& parameters, MeshDocument& document);

}  // namespace meshlab_host
