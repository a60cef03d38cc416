// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

class MeshModel;
class QObject;

namespace meshlab_host {

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

}  // namespace meshlab_host
