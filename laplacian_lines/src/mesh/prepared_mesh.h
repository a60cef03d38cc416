// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"
#include "mesh/corner_table.h"
#include "mesh/spatial_tree.h"
#include "mesh/triangle_sizes.h"

namespace laplacian_lines {

/// What a mesh was made from, by its flat faces: see origin_of().
enum class Origin { Scan, Voxels, FineDesign, Design };

/// √h for designed meshes, D: fillets that are narrower have one line, wider ones one a side.
constexpr double kDesignedKernel = 0.02;

/// The usable part of a mesh in local coordinates x' = (x − centre)/D, without degenerate
/// triangles, non-finite or unreferenced vertices. What follows is computed in these, so the
/// input's scale and offset do not matter.
struct PreparedMesh {
    std::vector<Eigen::Vector3d> positions;      ///< [N], local
    std::vector<Triangle> triangles;             ///< indices into positions
    std::vector<double> masses;                  ///< [N], a third of the incident area; once sorted
    std::vector<std::uint32_t> original_vertex;  ///< [N] -> index in the input
    /// Of each vertex of the input, that which it is welded to; empty: itself.
    std::vector<std::uint32_t> representative;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< centre of the bounding box, input units
    double diagonal = 0;                               ///< D, input units
    double mean_edge = 0;                              ///< ē, local
    double known_edge = 0;                             ///< TriangleMesh's, local
    Origin origin = Origin::Scan;
    /// Of the triangles; empty where they were changed since. See sides_of().
    std::optional<CornerTable> sides;
    MeshReport report;

    std::size_t size() const { return positions.size(); }
};

/// What to do about cuts, see stitch_cuts(), and sides without length.
enum class Cuts { Left, Stitched };

/// Whether triangles are turned: see orient().
enum class Facing { Kept, Outwards };

/// As they were for the mesh with this report.
inline Cuts cuts_of(const MeshReport& report) {
    return report.welded_vertices > 0 ? Cuts::Stitched : Cuts::Left;
}
inline Facing facing_of(const MeshReport& report) {
    return report.flipped_triangles > 0 ? Facing::Outwards : Facing::Kept;
}

/// The vertices keep the input's order. @throws Error: InvalidMesh, EmptyMesh.
PreparedMesh prepare_mesh(const TriangleMesh& mesh, Cuts cuts, Facing facing);

/// Without mean_edge, known_edge, origin and MeshReport::coordinate_step.
PreparedMesh prepare_geometry(const TriangleMesh& mesh, Cuts cuts, Facing facing);

/// Builds them if they are missing.
const CornerTable& sides_of(PreparedMesh& mesh);

/// Voxels are those of segmented volumes. Vertices of a Design are where the form needs them; the
/// triangles of a FineDesign are smaller than its kernel.
Origin origin_of(PreparedMesh& mesh);

/// The mean length of the triangles' sides.
double mean_edge(const std::vector<Eigen::Vector3d>& positions,
                 const std::vector<Triangle>& triangles);

/// Sorts vertices and triangles so that neighbours in space are neighbours in memory, in the order
/// of the returned tree. Keeps the cyclic order of corners. Sets the masses.
SpatialTree sort_in_space(PreparedMesh& mesh);

inline Eigen::Vector3d area_vector(const PreparedMesh& mesh, const Triangle& t) {
    return area_vector(mesh.positions, t);
}

}  // namespace laplacian_lines
