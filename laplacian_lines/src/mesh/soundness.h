// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/prepared_mesh.h"
#include "mesh/vertex_ranges.h"

namespace laplacian_lines {

/// Fills in what MeshReport tells about the edges of a mesh, and whether it is inside out.
void measure_soundness(const PreparedMesh& mesh, const VertexRanges& ranges, MeshReport& report);

}  // namespace laplacian_lines
