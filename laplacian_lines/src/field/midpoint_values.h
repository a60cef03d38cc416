// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/field.h"
#include "mesh/prepared_mesh.h"

namespace laplacian_lines {

/// Gives the vertices that undone subdivisions had added the means of what is at the ends of their
/// edges: normals, Δn, S, kernel sizes.
void fill_midpoints(const PreparedMesh& mesh, Field& field);

/// The same of S̄ and C, carried from the ends' tangent frames to theirs.
void fill_midpoint_derivatives(const PreparedMesh& mesh, Field& field);

}  // namespace laplacian_lines
