// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/triangle_mesh.h"

namespace test_meshes {

/// A head of soft blobs and hollows, as a surface between size³ voxels: by exact values, or, like
/// segmented volumes, by labels alone, in terraces. W. Lorensen, H. Cline, "Marching Cubes",
/// SIGGRAPH 1987, but polygons are followed from face to face instead of a table.
laplacian_lines::TriangleMesh smooth_head(int size);
laplacian_lines::TriangleMesh terraced_head(int size);

}  // namespace test_meshes
