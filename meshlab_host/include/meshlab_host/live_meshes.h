// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

class MeshModel;

namespace meshlab_host {

/// The ids of all meshes in the document of `mesh`, ascending. MeshLab 2022 and later do not let a
/// decoration reach the document: there the result is empty, which means "unknown".
std::vector<int> liveMeshIds(const MeshModel& mesh);

}  // namespace meshlab_host
