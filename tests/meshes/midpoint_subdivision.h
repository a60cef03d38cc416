// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/field.h"
#include "laplacian_lines/triangle_mesh.h"

namespace test_meshes {

/// Splits each triangle in four at the middles of its edges. Positions and the field are
/// interpolated, so the lines stay where they are: what grows is the mesh.
void subdivide(laplacian_lines::TriangleMesh& mesh, laplacian_lines::Field& field);

/// The same, so many times, of a mesh without a field.
void subdivide(laplacian_lines::TriangleMesh& mesh, int times);

}  // namespace test_meshes
