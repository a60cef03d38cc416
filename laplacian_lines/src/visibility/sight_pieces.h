// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "laplacian_lines/line_visibility.h"
#include "visibility/sight_segments.h"

namespace laplacian_lines {

/// Of two segments in the picture.
struct PictureCrossing {
    std::uint32_t segments[2];
    double shares[2];  ///< of the length of each, in the picture
};

/// All crossings of segments of which one divides. Lines on the surface are crossed only by what is
/// before them, segments with surface on both sides only in space by each other. The turns of the
/// four ends decide, found alike wherever they are asked for: a chain that passes over another
/// crosses it once, also at a vertex. The order does not depend on the number of threads.
std::vector<PictureCrossing> find_crossings(const SightSegments& all);

/// Between neighbouring crossings or ends: nothing changes along it.
struct SightPiece {
    std::uint32_t segment;
    /// In the picture: points of the segments, then crossings.
    std::uint32_t nodes[2];
    double shares[2];  ///< of the length of the segment, in the picture
    bool is_hidden;
    bool is_outline;  ///< seen, and on one side of it is nothing
    float gap;        ///< to what is behind it, local; infinite if there is nothing
};

/// Of all segments that are drawn, in order, each decided by one ray through its middle.
/// @throws Error(Cancelled)
std::vector<SightPiece> find_sight_pieces(const SightSegments& all,
                                          const std::vector<PictureCrossing>& crossings,
                                          const StageProgress& stage);

/// The number of the first node that is a crossing.
std::uint32_t first_crossing_node(const SightSegments& all);

/// Of lines on the surface, gaps below .1 % of D are seen and parts below .3 % are not.
void mend_lines(const SightSegments& all, std::vector<SightPiece>& pieces);

/// Joins pieces to lines where they meet in the same nodes: those of edges, outlines first, so that
/// they close, then the seen ones of lines on the surface.
std::vector<SightLine> trace_lines(const SightSegments& all, const std::vector<SightPiece>& pieces,
                                   const SightOptions& options);

/// The share in space at the begin (0) or end (1) of a piece of its segment.
double share_at(const SightSegments& all, const SightPiece& piece, int end);

}  // namespace laplacian_lines
