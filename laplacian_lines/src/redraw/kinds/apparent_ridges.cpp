// SPDX-License-Identifier: GPL-3.0-or-later
// Which apparent ridges a style shows: T. Judd, F. Durand, E. Adelson, "Apparent Ridges for Line
// Drawing", 2007.
#include "redraw/kinds/strip_kinds.h"

namespace laplacian_lines {
namespace {

/// The gradient is q1·D, the slope −d²q1/dr² h_e^1.5.
LineRules rules_of(const LineStyle& s, bool) {
    const Thresholds thresholds(s);
    LineRules rules = rules_by_slope(LineKind::ApparentRidge, s);
    rules.least_gradient = thresholds.apparent_curvature;
    rules.least_facing = 0;
    rules.leave_out_away = true;
    set_slopes(thresholds.apparent_slope, 6 * float(s.apparent_slope), rules);
    rules.least_strength = thresholds.apparent_strength;
    return rules;
}

}  // namespace

const StripKind apparent_ridge_strips = {
    LineKind::ApparentRidge,
    [](const LineStyle& style) { return style.shows[LineKind::ApparentRidge]; }, rules_of};

}  // namespace laplacian_lines
