// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "mesh/corner_table.h"
#include "mesh/prepared_mesh.h"

namespace laplacian_lines {

/// Meshes with more than this share of the area in flat faces of several triangles are CAD meshes;
/// even triangles of whose edges a tenth is flat have it, 1 − 0.9³. Scans and voxels of smooth
/// forms have up to 0.24, machined parts and lofts 0.29 and more.
constexpr double kCadShare = 0.27;
/// So are those with more than this share in triangles ten times as long as high, of strips over
/// curved faces: 110 scans have up to 0.11, five CAD meshes with few flat faces 0.20 and more.
constexpr double kNarrowShare = 0.15, kNarrow = 10;

/// Least cosine between neighbours in a flat face: of 0.1°.
constexpr double kFlatCosine = 0.9999984769132877;
/// Largest cosine between neighbours at a sharp edge: of 40°, from which edges are creases.
constexpr double kSharpCosine = 0.7660444431189781;

/// Neighbouring triangles in one plane are a flat face.
struct FlatFaces {
    std::vector<Eigen::Vector3d> normals;   ///< by triangle, unit
    std::vector<std::uint32_t> face_of;     ///< by triangle: the first one of its face
    std::vector<double> areas;              ///< by first triangle, twice, local units
    std::vector<std::uint8_t> has_several;  ///< by first triangle: whether it is not the only one

    double share = 0;         ///< of the area, in faces of several triangles
    double large_share = 0;   ///< of the area, in faces of at least kLargeFace of it
    double narrow_share = 0;  ///< of the area, in narrow triangles

    /// Whether the mesh was designed, not scanned, so that angles between triangles, however small,
    /// are those of the form.
    bool is_cad_mesh() const { return share > kCadShare || narrow_share > kNarrowShare; }
    /// Whether a third of the area is in large faces, as of plates and housings, not of terraces.
    bool are_large() const;
};

/// The number of threads does not matter.
FlatFaces flat_faces(const PreparedMesh& mesh, const CornerTable& sides);

/// What a triangle belongs to.
enum class FaceShape : std::uint8_t {
    Curved,   ///< a curved surface, or a single triangle
    Flat,     ///< a face with an edge of less than 40°, but no facet of a curved surface
    Enclosed  ///< a face with sharp edges, borders and edges of three triangles alone
};

/// By triangle. Flat faces, which only CAD meshes have, have their normal at all their corners, see
/// CornerNormals.
std::vector<FaceShape> face_shapes(const PreparedMesh& mesh, const CornerTable& sides,
                                   const FlatFaces& faces);

}  // namespace laplacian_lines
