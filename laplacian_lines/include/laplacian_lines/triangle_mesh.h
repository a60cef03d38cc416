// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace laplacian_lines {

using Triangle = std::array<std::uint32_t, 3>;

/// An indexed triangle mesh as the caller has it: any topology, any scale, any offset.
/// Triangles are counter-clockwise seen from outside. Vertices that are not finite, triangles that
/// use them, triangles without area and vertices without triangles are allowed; they are left out
/// and counted (see MeshReport).
struct TriangleMesh {
    std::vector<Eigen::Vector3d> positions;  ///< [V], in the mesh's own length unit
    std::vector<Triangle> triangles;         ///< [T], indices into positions
};

/// What the input held and what was left out of the computation.
struct MeshReport {
    std::size_t vertices = 0;               ///< all vertices of the input
    std::size_t triangles = 0;              ///< all triangles of the input
    std::size_t non_finite_vertices = 0;    ///< a coordinate is NaN or infinite
    std::size_t unreferenced_vertices = 0;  ///< finite, but no usable triangle has it
    std::size_t degenerate_triangles = 0;   ///< zero area, repeated or non-finite corners
    std::size_t welded_vertices = 0;        ///< for which another one at the same place counts
    /// Of the surface at the scale of its triangles: noise, or the terraces of segmented volumes.
    /// No unit; scans have up to 1.1, terraces 1.5 to 3. 0: smooth.
    double roughness = 0;
    // What faults_of() judges by, of the surface that is left, its cuts closed.
    double border_share = 0;     ///< of its edges, those of one triangle
    double opposed_share = 0;    ///< those of two triangles that disagree about the outside
    double openness = 0;         ///< |Σ area vectors| / area: 0 closed, 1 a plane
    double relative_volume = 0;  ///< 3 volume / (area · D), about the centre; negative: inside out
    double kernel_bend = 0;      ///< median of curvature · kernel size; 0: as small as may be
};

}  // namespace laplacian_lines
