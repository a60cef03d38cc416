// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/field.h"
#include "laplacian_lines/triangle_mesh.h"

namespace test_meshes {

/// Splits each triangle in four and interpolates positions and field, so that lines stay put.
void subdivide(laplacian_lines::TriangleMesh& mesh, laplacian_lines::Field& field);

/// Repeatedly, without a field.
void subdivide(laplacian_lines::TriangleMesh& mesh, int times);

}  // namespace test_meshes
