// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "clusters/extractor_data.h"
#include "clusters/planes.h"

namespace laplacian_lines {

/// The edges that contours can follow: those of coarse triangles, see coarseness.h. Local
/// coordinates; vertices and triangles have numbers of their own. Empty on a fine mesh.
struct CoarseHorizon {
    /// Between two coarse triangles.
    struct Edge {
        std::uint32_t vertices[2];
        std::uint32_t triangles[2];
        bool is_reversed;  ///< the two triangles are of opposite orientation
        bool is_hollow;    ///< of a body, which hides a contour there: what faces away is before it
    };
    /// Between a coarse triangle and one that is not. There a contour can come from the other
    /// side, at the edge of this number in ExtractorData::border_edges.
    struct OuterEdge {
        std::uint32_t number;  ///< ascending
        std::uint32_t vertices[2];
        std::uint32_t triangle;
    };
    std::vector<Edge> edges;
    std::vector<OuterEdge> outer_edges;
    std::vector<Eigen::Vector3f> positions;  ///< by vertex
    Planes facing;                           ///< by vertex: n·(e − w p)
    Planes planes;                           ///< by triangle; N is its unit normal

    bool empty() const { return edges.empty() && outer_edges.empty(); }
    std::size_t memory() const;  ///< bytes, but for the object itself
};

/// Needs the clusters.
CoarseHorizon find_coarse_horizon(const ExtractorData& data);

}  // namespace laplacian_lines
