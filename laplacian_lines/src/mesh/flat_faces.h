// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/prepared_mesh.h"

namespace laplacian_lines {

/// Of its area in faces of several triangles, as where a tenth of even triangles' edges is flat
/// (1 − 0.9³): a mesh with more was made. Scans and voxels of smooth forms have up to 0.24,
/// machined parts and lofts 0.29 and more.
constexpr double kMadeShare = 0.27;

/// Whether a mesh was made, not measured: much of its area is in faces of several triangles, so
/// that angles between triangles are those of the form, however small. The number of threads does
/// not matter.
bool is_made(const PreparedMesh& mesh);

/// Whether a third of a mesh's area and more is in flat faces that are large against it: plates,
/// housings; not terraces of voxels.
bool has_large_faces(const PreparedMesh& mesh);

}  // namespace laplacian_lines
