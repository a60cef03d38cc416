// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "laplacian_lines/line_set.h"
#include "redraw/strips.h"
#include "rules/line_parts.h"

namespace laplacian_lines {

/// The lines of a view as sequences of strips.
struct TracedLines {
    struct Line {
        Polyline polyline;  ///< with its place in the line set
        std::uint32_t first_end, end_count;
        std::uint32_t first_knot;  ///< of parts of whole lines
        const LineRules* rules;
        const JoinedStrip* strips;
    };
    /// What LinePartFinder found where two strips meet, and at the ends.
    struct Knot {
        float slope, opacity;
    };
    std::vector<Line> lines;
    std::vector<std::uint32_t> ends;  ///< where strips are entered, see JoinedStrip
    std::vector<Knot> knots;
    std::uint32_t point_count = 0;

    void clear() {
        lines.clear();
        ends.clear();
        knots.clear();
        point_count = 0;
    }
};

/// What trace_lines() finds parts in.
struct PartMemory {
    std::vector<std::uint32_t> ends;
    std::vector<LinePiece> pieces;
    LinePartFinder finder;
};

/// The rules on the sums of a line; of LineRules::whole, on those of a part that is drawn.
inline bool accepts(const LineRules& rules, const Polyline& line) {
    return line.length >= rules.least_length && line.strength >= rules.least_strength &&
           (!rules.use_slope || line.slope >= rules.line_slope);
}

/// Appends the lines that strips make, or by LineRules::whole their parts that are drawn, if
/// accepts() holds. Visits all strips. Source: Zhang, He, Xie, Chen, step 3 and Eq. 4 (strength).
void trace_lines(const LineRules& rules, std::vector<JoinedStrip>& strips, PartMemory& memory,
                 TracedLines& traced);

}  // namespace laplacian_lines
