// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/prepared_mesh.h"

namespace laplacian_lines {

/// Whether the triangles of a coarse mesh are turned by noise: their normals differ from those of
/// the best quadric through their neighbours by about as much everywhere, and by as much as that
/// bends. On a clean coarse mesh they do so at its edges and details only. Looks at the two rings
/// of triangles around a thousand vertices. False on meshes that are too fine to be drawn by their
/// triangles, and on those that are too coarse to tell. The mesh is sorted in space; the number of
/// threads does not matter.
bool has_noisy_facets(const PreparedMesh& mesh);

}  // namespace laplacian_lines
