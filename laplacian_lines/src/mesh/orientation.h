// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/prepared_mesh.h"

namespace laplacian_lines {

/// Turns triangles so that neighbours agree about the outside where that is possible, and closed
/// bodies, but for holes as scans have them, face outwards. What lies in a body turns with it, so
/// that cavities stay; open surfaces keep the side of most of their area. Fills in what MeshReport
/// tells about edges and turned triangles.
void orient(PreparedMesh& mesh);

}  // namespace laplacian_lines
