// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/prepared_mesh.h"

namespace laplacian_lines {

/// Turns triangles so that neighbours agree about the outside in each component that can be
/// oriented, and closed bodies face outwards, see orientation.cpp. Fills in the edges and turned
/// triangles of MeshReport.
void orient(PreparedMesh& mesh);

}  // namespace laplacian_lines
