// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "laplacian_lines/field.h"
#include "mesh/flat_faces.h"
#include "mesh/prepared_mesh.h"

namespace laplacian_lines {

/// Whether edges of the mesh are those of noise or voxels, not of the form.
bool is_rough(const MeshReport& report);

/// Whether contours are edges of the mesh, between a triangle that faces the eye and one that does
/// not, instead of zeros of n·v: if more than a quarter of the area, 2 % on a CAD mesh that is not
/// rough, is in coarse triangles, where the two would be too far apart in the picture. The number
/// of threads does not matter.
bool follows_edges(const PreparedMesh& mesh, bool is_cad, const Field& field);

/// Which triangles have no feature of their own, 1 or 0 for each: Laplacian lines found there come
/// from beyond an edge, over which the kernel reaches. Those of faces that are flat by design,
/// those whose corners are all flat, and those so long that flat or gentle corners and sharp ones
/// are all there is of the form. At a flat corner every triangle is within .1° of the largest one,
/// at a sharp one some is at 40° or more. None on a mesh without a sharp corner. The number of
/// threads does not matter.
std::vector<std::uint8_t> find_featureless_triangles(const PreparedMesh& mesh,
                                                     const std::vector<FaceShape>& shapes);

}  // namespace laplacian_lines
