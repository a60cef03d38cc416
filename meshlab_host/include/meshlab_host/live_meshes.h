// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

class MeshModel;

namespace meshlab_host {

/// The ids of all meshes in the document of `mesh`, ascending. Empty if the document cannot be
/// found, as in programs without MeshLab's GUI.
std::vector<int> liveMeshIds(const MeshModel& mesh);

}  // namespace meshlab_host
