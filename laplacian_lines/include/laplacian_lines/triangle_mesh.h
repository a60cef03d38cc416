// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace laplacian_lines {

using Triangle = std::array<std::uint32_t, 3>;

/// An indexed triangle mesh: any topology, scale and offset; triangles counter-clockwise seen from
/// outside, or turned that way, see MeshReport. Vertices that are not finite or not used, and
/// triangles without area or with corners that are not finite, are dropped and counted there.
struct TriangleMesh {
    std::vector<Eigen::Vector3d> positions;  ///< [V], in the mesh's own length unit
    std::vector<Triangle> triangles;         ///< [T], indices into positions
    /// [V], or empty. Unit normals for precompute(), outward; where 0, and if empty, those of the
    /// triangles count.
    std::vector<Eigen::Vector3d> normals = {};
    /// Of refined() meshes, 0 of others: the mean edge (mesh units), the roughness and the number
    /// of vertices, which come first, of the mesh before. Options in mean edges count in that edge.
    double known_edge = 0;
    double known_roughness = 0;
    std::size_t known_vertices = 0;
};

/// The usable triangles, with cracks and T-junctions resolved as by precompute() and LineExtractor:
/// triangles on borders are cut where vertices of other borders lie on their sides, and share
/// vertices, so that surfaces which are closed but for these share all edges. Vertices stay.
/// @throws Error(InvalidMesh)
std::vector<Triangle> conforming_triangles(const TriangleMesh& mesh);

/// What the input held, and what was dropped or repaired.
struct MeshReport {
    std::size_t vertices = 0;               ///< all vertices of the input
    std::size_t triangles = 0;              ///< all triangles of the input
    std::size_t non_finite_vertices = 0;    ///< a coordinate is NaN or infinite
    std::size_t unreferenced_vertices = 0;  ///< finite, but in no usable triangle
    std::size_t degenerate_triangles = 0;   ///< no area, repeated or non-finite corners
    /// Merged with another one at a cut or crack, or at the end of a side without length.
    std::size_t welded_vertices = 0;
    /// Noise at the scale of the triangles, or terraces of segmented volumes, dimensionless. Clean
    /// meshes have 0, noise of a fifth of the edges 1, terraces 1.5 to 3.
    double roughness = 0;
    /// Triangles whose orientation was reversed, so that neighbours agree and closed bodies face
    /// outwards: normals are those of the mesh that results.
    std::size_t flipped_triangles = 0;
    // For faults_of(): shares of all edges of the usable surface, welded and turned.
    double border_share = 0;   ///< of one triangle; 0 if all triangles are connected
    double opposed_share = 0;  ///< whose two triangles still disagree about the outside
    /// The step of the grid, wherever its origin, on which all vertices lie, input units, if it is
    /// at least a tenth of the mean edge. Else, and for few triangles, large flat faces or cells of
    /// a grid, 0.
    double coordinate_step = 0;
};

}  // namespace laplacian_lines
