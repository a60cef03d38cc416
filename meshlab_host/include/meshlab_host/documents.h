// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <vector>

#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

std::vector<const MeshModel*> layersOf(const MeshDocument& document);

/// All meshes in the document of `mesh`, ascending. Empty if there is no document, as without a
/// GUI.
std::vector<int> liveMeshIds(const MeshModel& mesh);

/// Of these, those that MeshLab shows.
std::vector<int> shownMeshIds(const MeshModel& mesh);

/// The document of `mesh`. Null if there is none.
MeshDocument* documentOf(const MeshModel& mesh);

/// Calls `changed` with the ids of the document's meshes, ascending, when meshes come or go, and
/// with none when it closes, as long as `receiver` lives. GUI thread only.
void whenMeshesChange(const MeshDocument* document, QObject* receiver,
                      const std::function<void(const std::vector<int>&)>& changed);

/// The log of the document of `mesh`. Null if there is no document, as without a GUI. GUI thread
/// only.
GLLogStream* documentLog(const MeshModel& mesh);

/// Shows text in the corner of the view until the next redraw. `mesh` is shown only if two boxes
/// have the same title. GUI thread only, while drawing.
void writeOnView(GLLogStream& log, const QString& title, const QString& mesh, const QString& text);

/// Puts these parameters into MeshLab's record of a filter that its dialog has run, once MeshLab
/// has made it: scripts that are saved have them. The last thing that the filter does, since
/// progress runs MeshLab's events.
void recordAs(const QString& filter, const RichParameterList& parameters, MeshDocument& document);

}  // namespace meshlab_host
