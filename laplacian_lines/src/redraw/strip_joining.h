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
    std::uint32_t links[2];  ///< the end that goes on, or kNoEnd
    float length, strength, slope, concave;
    bool visited;
    bool exact;  ///< its points stay where they are, see LineSums::has_exact
};

/// Where nothing goes on at an edge that others share.
struct OpenEnd {
    std::uint32_t edge;
    std::uint32_t end;  ///< of a strip
};

struct JoiningMemory {
    std::vector<JoinedStrip> strips[kStripKindCount];
    /// The end that waits at an edge; kNoEnd everywhere between uses.
    std::vector<std::uint32_t> end_at_edge;
    bool in_use = false;             ///< an exception left end_at_edge behind
    std::vector<OpenEnd> open_ends;  ///< of the kind that was joined last
};

/// Replaces memory.strips[kind] by the strips of that kind, joined where two of them end at an
/// edge, and memory.open_ends by what is left over.
void join_strips(const FoundStrips& found, unsigned kind, std::uint32_t border_edge_count,
                 JoiningMemory& memory);

}  // namespace laplacian_lines
