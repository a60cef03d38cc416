// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/triangle_mesh.h"

namespace laplacian_lines {

/// Undoes midpoint subdivisions: while all triangles, their corners welded, are quarters of larger
/// ones, cut at the middles of their sides within the rounding of floats, replaces them by these,
/// in the order of their first quarters. Forms of a few large triangles were subdivided for a
/// reason and stay. Other meshes take little time.
void undo_subdivisions(TriangleMesh& mesh);

}  // namespace laplacian_lines
