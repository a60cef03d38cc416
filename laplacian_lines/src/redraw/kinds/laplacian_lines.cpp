// SPDX-License-Identifier: GPL-3.0-or-later
// Which Laplacian lines a style shows: L. Zhang, Y. He, H. S. Seah, "Laplacian Lines for Real-Time
// Shape Illustration"; what differs from the paper is told at the members of LineStyle.
#include "redraw/kinds/strip_kinds.h"
#include "rules/convexity.h"

namespace laplacian_lines {
namespace {

bool is_wanted(const LineStyle& style) {
    return style.shows[LineKind::Laplacian];
}

LineRules rules_of(const LineStyle& s, bool light_at_eye) {
    const Thresholds thresholds(s);
    LineRules rules = rules_by_slope(LineKind::Laplacian, s);
    rules.least_gradient = thresholds.gradient;
    rules.least_facing = float(s.least_facing);
    rules.reject_phantoms = s.reject_phantoms;
    rules.concave_only = s.single_strokes;
    rules.least_concavity = float(s.least_concavity);
    rules.leave_out_convex = s.single_strokes && s.fading <= kMostFadingOfConvex;
    rules.segment_slope = thresholds.segment_slope;
    rules.line_slope = thresholds.line_slope;
    rules.full_slope = float(s.full_slope);
    rules.least_strength = thresholds.strength;
    if (!light_at_eye) rules.contour_clearance = 0;
    rules.leave_out_away = rules.contour_clearance > 0;
    return rules;
}

}  // namespace

const StripKind laplacian_line_strips = {LineKind::Laplacian, is_wanted, rules_of};

}  // namespace laplacian_lines
