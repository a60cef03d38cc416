// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <vector>

#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

/// The layers of a document, in its order.
std::vector<const MeshModel*> layersOf(const MeshDocument& document);

/// Whether a filter works on the layers now: nobody else may look at them, although the progress
/// bar lets events in.
bool isBusy(const MeshDocument& document);

/// The ids of all meshes in the document of `mesh`, ascending. Empty if the document cannot be
/// found, as in programs without MeshLab's GUI.
std::vector<int> liveMeshIds(const MeshModel& mesh);

/// The document of `mesh`: a name, and a sender of signals. Null if it cannot be found.
QObject* documentOf(const MeshModel& mesh);

/// Calls `changed` with the ids of all meshes of a document, ascending, whenever meshes have come
/// or gone, and with none when it is closed. `document` must come from documentOf(). Nothing is
/// called after `receiver` is destroyed. GUI thread only.
void whenMeshesChange(QObject* document, QObject* receiver,
                      const std::function<void(const std::vector<int>&)>& changed);

/// The log of the document of `mesh`, the one that is handed to whoever draws it. Null if the
/// document cannot be found, as in programs without MeshLab's GUI. GUI thread only.
GLLogStream* documentLog(const MeshModel& mesh);

/// Whether the log has this line. Previews of filters take lines out of it again.
bool hasLine(const GLLogStream& log, const QString& line);

/// Shows text in the corner of the view until the next redraw. `mesh` is printed only where two
/// boxes have the same title. GUI thread only, while drawing.
void writeOnView(GLLogStream& log, const QString& title, const QString& mesh, const QString& text);

}  // namespace meshlab_host
