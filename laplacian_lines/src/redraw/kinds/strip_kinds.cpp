// SPDX-License-Identifier: GPL-3.0-or-later
#include "redraw/kinds/strip_kinds.h"

#include <algorithm>

namespace laplacian_lines {

LineRules rules_by_slope(LineKind kind, const LineStyle& s) {
    LineRules rules;
    rules.kind = kind;
    rules.leave_out_plain = s.shows[LineKind::Crease];
    rules.use_slope = true;
    rules.whole = s.whole_lines;
    rules.least_length = Thresholds(s).shortest_line;
    rules.fading = float(s.fading);
    rules.smoothing_passes = smoothing_passes(s.line_smoothing);
    rules.end_length = float(s.end_length);
    if (s.shows[LineKind::Contour]) rules.contour_clearance = float(s.contour_clearance);
    return rules;
}

void set_slopes(float least, float full, LineRules& rules) {
    constexpr float positive = 1e-6f;  // weights are divided by it
    rules.segment_slope = least;
    rules.line_slope = 2 * least;
    rules.full_slope = std::max(full, positive);
}

}  // namespace laplacian_lines
