// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/corner_table.h"
#include "mesh/prepared_mesh.h"

namespace laplacian_lines {

/// CAD meshes have more than this share of the area in flat faces of several triangles; it is that
/// of even triangles of whose edges a tenth is flat, 1 − 0.9³. Scans and voxels of smooth forms
/// have up to 0.24, machined parts and lofts 0.29 and more.
constexpr double kCadShare = 0.27;

/// Least cosine between neighbours in a flat face: of 0.1°.
constexpr double kFlatCosine = 0.9999984769132877;

/// Flat faces of several triangles.
struct FlatFaces {
    double share = 0;        ///< of the area
    double large_share = 0;  ///< of the area, in faces of at least kLargeFace of it

    /// Whether the mesh was designed, not scanned, so that angles between triangles, however small,
    /// are those of the form.
    bool is_cad_mesh() const { return share > kCadShare; }
    /// Whether a third of the area is in large faces, as of plates and housings, not of terraces.
    bool are_large() const;
};

/// The number of threads does not matter.
FlatFaces flat_faces(const PreparedMesh& mesh, const CornerTable& sides);

}  // namespace laplacian_lines
