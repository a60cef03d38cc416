// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "laplacian_lines/field.h"
#include "mesh/prepared_mesh.h"

namespace laplacian_lines {

/// Whether edges of the mesh are those of noise or voxels, not of the form.
bool is_rough(const MeshReport& report);

/// Whether contours follow edges of the mesh, because a quarter of its area is coarse. In a fine
/// triangle the zero of n·l lies near the horizon of the triangles: a contour's triangle is seen at
/// most as steeply as its plane leans away from the normals n of its corners, so the two are at
/// most its size times the sine of that angle apart in the picture. In a coarse one that is too
/// far, or it is large. On rough meshes only large ones count. On a CAD mesh, with flat faces of
/// several triangles, all count that lean by 10° and more, however small, and 2 % are
/// enough. The number of threads does not matter.
bool follows_edges(const PreparedMesh& mesh, bool is_cad, const Field& field);

/// Which triangles have no feature of their own, 1 or 0 for each: Laplacian lines found there come
/// from beyond an edge, over which the kernel reaches. Those whose corners are all flat, or so long
/// that flat corners and sharp ones are all there is of the form. At a flat corner every triangle
/// is within .1° of one of them, at a sharp one some is at 40° or more. None on a mesh without a
/// sharp corner.
std::vector<std::uint8_t> find_featureless_triangles(const PreparedMesh& mesh);

}  // namespace laplacian_lines
