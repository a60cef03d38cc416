// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "clusters/extractor_data.h"
#include "clusters/planes.h"
#include "redraw/strips.h"

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

/// Memory of append_horizon(); keeps its capacity.
struct HorizonMemory {
    /// A piece of an edge of the mesh. Its ends are vertices, or the ends of strips: these have the
    /// number of vertices plus their place in JoiningMemory::open_ends.
    struct Segment {
        std::uint32_t ends[2];
        bool is_hollow;
    };
    std::vector<float> triangle_facing, vertex_facing;
    std::vector<Segment> segments;
    std::vector<std::uint32_t> links;         ///< by half of a segment, see chains.h
    std::vector<std::uint32_t> next_at_end;   ///< by half: another one that begins there
    std::vector<std::uint32_t> first_at_end;  ///< by end; kNoEnd everywhere between uses
    std::vector<std::uint8_t> visited;        ///< by segment
    std::vector<StripPoint> points;
    /// Chains of segments.
    struct Chain {
        std::uint32_t first_point, point_count;
        std::uint32_t ends[2];
        bool closed;
    };
    std::vector<Chain> chains;
    bool in_use = false;  ///< an exception left first_at_end behind
};

/// The horizon where triangles are coarse: the edges, and parts of edges, at which what is seen
/// from the front and what is seen from behind meet. A coarse triangle faces the eye or not as its
/// plane does, others as n·l does, so that together with the zeros of n·l, which are the strips of
/// contours, these edges bound the part of a surface that faces the eye: without gaps, and closed
/// but for the surface's own borders.
/// Both ends of a hollow one, which its own body hides, have -0 as gradient.
/// Appends them to `joining.strips[kind]`, exact, and joins them to the strips in
/// `joining.open_ends` that end at coarse triangles. Points are in `memory`.
void append_horizon(const CoarseHorizon& horizon, const LocalEye& eye, unsigned kind,
                    JoiningMemory& joining, HorizonMemory& memory);

}  // namespace laplacian_lines
