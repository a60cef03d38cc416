// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"
#include "system/parallel.h"

namespace laplacian_lines {

/// Largest distance of a vertex from the centre of the bounding box, local.
constexpr double kMeshReach = 0.5;

/// A surface with all its edges, of any topology and winding: equal vertices are merged, triangles
/// without height dropped, and edges split at vertices that lie on them, so that surfaces which
/// touch share edges. Intersecting triangles share an edge, too, with both triangles on both sides.
/// In local coordinates x' = (x − centre) / size. Unlike a corner table, edges have any number of
/// triangles, and may be parts of their sides.
struct VisibilityMesh {
    /// A side of a triangle, or a part of one between vertices on it. A triangle on both sides of
    /// an edge has two, of both directions.
    struct Side {
        std::uint32_t triangle : 31;
        /// The triangle goes from the edge's second vertex to its first.
        std::uint32_t is_reversed : 1;
    };
    struct Edge {
        std::array<std::uint32_t, 2> vertices;  ///< ascending
        std::uint32_t first_side;               ///< in `sides`, up to that of the next edge
    };

    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double size = 1;            ///< D, mesh units
    double precision = 0;       ///< local: distance up to which points count as equal
    double line_precision = 0;  ///< the same for points of lines, which are floats
    std::vector<Eigen::Vector3d> positions;
    std::vector<Triangle> triangles;
    std::vector<Edge> edges;  ///< in the order of their vertices; one more follows the last
    std::vector<Side> sides;  ///< by edge, none twice
    /// The body of each triangle, connected by edges of two; empty if all edges have at most two.
    std::vector<std::uint32_t> bodies;
    std::vector<std::uint32_t> along_curve;  ///< numbers of triangles: see order_along_curve()

    Eigen::Vector3d local(const Eigen::Vector3d& point) const { return (point - centre) / size; }
    Eigen::Vector3d in_mesh(const Eigen::Vector3d& local) const { return centre + size * local; }
    std::size_t edge_count() const { return edges.empty() ? 0 : edges.size() - 1; }
    std::size_t side_count(std::uint32_t edge) const {
        return edges[edge + 1].first_side - edges[edge].first_side;
    }
    const Side* sides_of(std::uint32_t edge) const { return &sides[edges[edge].first_side]; }

    static constexpr std::uint32_t kNoEdge = 0xffffffffu;
    /// kNoEdge if there is none.
    std::uint32_t edge_between(std::uint32_t a, std::uint32_t b) const;
    Eigen::Vector3d normal(std::uint32_t triangle) const;
};

/// Drops triangles whose corners are not finite. @throws Error: InvalidMesh, Cancelled.
VisibilityMesh build_visibility_mesh(const TriangleMesh& mesh, const StageProgress& stage);
/// For a part of another mesh, whose local coordinates it keeps.
VisibilityMesh build_visibility_mesh(TriangleMesh part, const VisibilityMesh& whole,
                                     const StageProgress& stage);

}  // namespace laplacian_lines
