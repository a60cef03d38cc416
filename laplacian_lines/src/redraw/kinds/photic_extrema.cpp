// SPDX-License-Identifier: GPL-3.0-or-later
// Which photic extremum lines a style shows: X. Xie et al., "An Effective Illustrative
// Visualization Framework Based on Photic Extremum Lines (PELs)", 2007.
#include "redraw/kinds/strip_kinds.h"

namespace laplacian_lines {
namespace {

/// Those of Laplacian lines, but for the slope: the second derivative of ‖∇I‖ along ∇I, times
/// D·h_e^1.5.
LineRules rules_of(const LineStyle& s, bool light_at_eye) {
    LineRules rules = laplacian_line_strips.rules(s, light_at_eye);
    rules.kind = LineKind::PhoticExtremum;
    set_slopes(Thresholds(s).photic_slope, 12 * float(s.photic_slope), rules);
    return rules;
}

}  // namespace

const StripKind photic_extremum_strips = {
    LineKind::PhoticExtremum,
    [](const LineStyle& style) { return style.shows[LineKind::PhoticExtremum]; }, rules_of};

}  // namespace laplacian_lines
