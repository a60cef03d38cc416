// SPDX-License-Identifier: GPL-3.0-or-later
// Which occluding contours a style shows.
#include "redraw/kinds/strip_kinds.h"

namespace laplacian_lines {

LineRules contour_rules(const LineStyle& style) {
    LineRules rules;
    rules.kind = LineKind::Contour;
    rules.least_length = float(style.shortest_contour);
    rules.concave_thinning = 0.1f;
    rules.leave_out_coarse = style.exact_outlines;
    rules.smoothing_passes = smoothing_passes(style.line_smoothing);
    return rules;
}

const StripKind contour_strips = {
    LineKind::Contour, [](const LineStyle& style) { return style.shows[LineKind::Contour]; },
    [](const LineStyle& style, bool) { return contour_rules(style); }};

}  // namespace laplacian_lines
