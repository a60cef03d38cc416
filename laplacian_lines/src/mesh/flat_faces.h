// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/corner_table.h"
#include "mesh/prepared_mesh.h"

namespace laplacian_lines {

/// Of its area in faces of several triangles, as where a tenth of even triangles' edges is flat
/// (1 − 0.9³): a mesh with more was made. Scans and voxels of smooth forms have up to 0.24,
/// machined parts and lofts 0.29 and more.
constexpr double kMadeShare = 0.27;

/// Flat faces of several triangles.
struct FlatFaces {
    double share = 0;        ///< of the area
    double large_share = 0;  ///< of the area, in faces that are large against it

    /// Whether a mesh was made, not measured, so that angles between triangles are those of the
    /// form, however small.
    bool are_made() const { return share > kMadeShare; }
    /// Whether a third of the area and more is in large ones: plates, housings; not terraces of
    /// voxels.
    bool are_large() const;
};

/// The number of threads does not matter.
FlatFaces flat_faces(const PreparedMesh& mesh, const CornerTable& sides);

}  // namespace laplacian_lines
