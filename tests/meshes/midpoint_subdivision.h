// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/field.h"
#include "laplacian_lines/triangle_mesh.h"

namespace test_meshes {

/// Splits each triangle in four and interpolates positions and field, so that lines stay put.
void subdivide(laplacian_lines::TriangleMesh& mesh, laplacian_lines::Field& field);

/// Repeatedly, without a field.
void subdivide(laplacian_lines::TriangleMesh& mesh, int times);

/// As many triangles, but round like a finer scan: new vertices are where a cubic curve between the
/// ends of their edge, at right angles to the normals there, has its middle. A. Vlachos et al.,
/// "Curved PN Triangles", I3D 2001.
void refine(laplacian_lines::TriangleMesh& mesh, int times);

}  // namespace test_meshes
