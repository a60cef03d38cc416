// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "redraw/strip_finding.h"
#include "system/chains.h"

namespace laplacian_lines {

/// A strip and what goes on at its ends, see chains.h.
struct JoinedStrip {
    const StripPoint* points;
    std::uint32_t count;
    float length, strength, slope, concave;
    bool exact = false;                         ///< as LineSums::has_exact
    bool visited = false;                       ///< by trace_lines()
    std::uint32_t links[2] = {kNoEnd, kNoEnd};  ///< the end that goes on
};

/// Where nothing goes on at an edge that others share.
struct OpenEnd {
    std::uint32_t edge;
    std::uint32_t end;  ///< of a strip
};

struct JoiningMemory {
    std::vector<JoinedStrip> strips[kStripKindCount];
    /// The end that waits at an edge, plus first_end; what is less is of an earlier use.
    std::vector<std::uint32_t> end_at_edge;
    std::uint32_t first_end = 1, next_end = 1;  ///< of the last use, and of the next one
    std::vector<OpenEnd> open_ends;
};

/// Replaces memory.strips[kind] by the strips of that kind, joined where two of them end at an
/// edge.
void join_strips(const FoundStrips& found, unsigned kind, std::uint32_t border_edge_count,
                 JoiningMemory& memory);

/// Replaces memory.open_ends by what join_strips() has left over of this kind.
void find_open_ends(const FoundStrips& found, unsigned kind, JoiningMemory& memory);

}  // namespace laplacian_lines
