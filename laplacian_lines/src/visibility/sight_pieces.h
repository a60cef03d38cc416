// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "laplacian_lines/line_visibility.h"
#include "visibility/sight_segments.h"

namespace laplacian_lines {

/// Where two segments cross each other in the picture.
struct PictureCrossing {
    std::uint32_t segments[2];
    double shares[2];  ///< of the length of each, in the picture
};

/// All crossings of segments of which one divides; lines on the surface are crossed only by what is
/// before them, and segments that have surface on both sides only by each other in space. Whether
/// segments cross is decided by the turns of their four ends, each of which is found alike wherever
/// it is asked for: so a chain of segments that passes over another one crosses it once, also at a
/// vertex. In an order that does not depend on the number of threads.
std::vector<PictureCrossing> find_crossings(const SightSegments& all, const StageProgress& stage);

/// A part of a segment between neighbouring crossings or ends: nothing changes along it.
struct SightPiece {
    std::uint32_t segment;
    /// In the picture: points of the segments, and behind these crossings.
    std::uint32_t nodes[2];
    double shares[2];  ///< of the length of the segment, in the picture
    bool is_hidden;
    bool is_outline;  ///< seen, and on one side of it is nothing
    float gap;        ///< to what is behind it, local; infinite if there is nothing
};

/// The pieces of all segments that are drawn, in their order, each decided by one ray through its
/// middle. @throws Error(Cancelled)
std::vector<SightPiece> find_sight_pieces(const SightSegments& all,
                                          const std::vector<PictureCrossing>& crossings,
                                          const StageProgress& stage);

/// The number of the first node that is a crossing.
std::uint32_t first_crossing_node(const SightSegments& all);

/// Joins the pieces of edges of the mesh to lines. Outlines first, where pieces meet in the same
/// nodes: these lines are closed, and nothing that follows takes of them.
void trace_edges(const SightSegments& all, const std::vector<SightPiece>& pieces,
                 const SightOptions& options, std::vector<SightLine>& traced);

/// Joins the pieces of lines on the surface that are seen. Gaps of less than .1 % of D and parts of
/// less than .3 % do not count.
void trace_surface_lines(const SightSegments& all, const std::vector<SightPiece>& pieces,
                         const std::vector<LineSet>& lines, const SightOptions& options,
                         std::vector<SightLine>& traced);

/// Passes of binomial smoothing, as of smooth_positions(): exact points and open ends stay.
void smooth_between_exact(int passes, SightLine& line);

}  // namespace laplacian_lines
