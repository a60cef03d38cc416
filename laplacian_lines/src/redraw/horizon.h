// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "clusters/coarse_horizon.h"
#include "clusters/extractor_data.h"
#include "redraw/strips.h"

namespace laplacian_lines {

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
