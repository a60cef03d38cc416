// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "visibility/picture_crossings.h"
#include "visibility/sight_segments.h"

namespace laplacian_lines {

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

}  // namespace laplacian_lines
