// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/corner_table.h"
#include "mesh/prepared_mesh.h"

namespace laplacian_lines {

/// Of its area in faces of several triangles, as where a tenth of even triangles' edges is flat
/// (1 − 0.9³): a mesh with more was made. Scans and voxels of smooth forms have up to 0.24,
/// machined parts and lofts 0.29 and more.
constexpr double kMadeShare = 0.27;

/// Of the area, in faces of several triangles. The number of threads does not matter.
double flat_share(const PreparedMesh& mesh, const CornerTable& sides);

/// Whether a mesh was made, not measured, so that angles between triangles are those of the form,
/// however small.
inline bool is_made(const PreparedMesh& mesh, const CornerTable& sides) {
    return flat_share(mesh, sides) > kMadeShare;
}

/// Whether a third of a mesh's area and more is in flat faces that are large against it: plates,
/// housings; not terraces of voxels.
bool has_large_faces(const PreparedMesh& mesh, const CornerTable& sides);

}  // namespace laplacian_lines
