// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "laplacian_lines/line_set.h"
#include "redraw/strip_joining.h"
#include "rules/line_rules.h"

namespace laplacian_lines {

/// The lines of a view as sequences of strips.
struct TracedLines {
    struct Line {
        Polyline polyline;  ///< with its place in the line set
        std::uint32_t first_end, end_count;
        bool has_exact;  ///< as in LineSums
        const LineRules* rules;
        const JoinedStrip* strips;
    };
    std::vector<Line> lines;
    std::vector<Line> whole;  ///< by LineRules::whole: of which parts are drawn, not counted yet
    std::vector<std::uint32_t> ends;  ///< where strips are entered, see JoinedStrip
    std::uint32_t point_count = 0;

    void clear() {
        lines.clear();
        whole.clear();
        ends.clear();
        point_count = 0;
    }
};

/// Appends the lines that strips make and that the rules on whole lines accept, or all of them if
/// their parts are to be judged. Visits all strips.
/// Source: Zhang, He, Seah, step 3 (tracing) and Eq. 4 (strength).
void trace_lines(const LineRules& rules, std::vector<JoinedStrip>& strips, TracedLines& traced);

}  // namespace laplacian_lines
