// SPDX-License-Identifier: GPL-3.0-or-later
// Which suggestive contours and highlights a style shows: D. DeCarlo, A. Finkelstein, S.
// Rusinkiewicz, A. Santella, "Suggestive Contours for Conveying Shape" (2003); D. DeCarlo, S.
// Rusinkiewicz, "Highlight Lines for Conveying Shape" (2007).
#include "redraw/kinds/strip_kinds.h"

namespace laplacian_lines {
namespace {

/// The slope is the derivative of the radial curvature towards the eye, over the cosine of normal
/// and view, times h_e, all to the power 1.5.
LineRules rules_of(const LineStyle& s, LineKind kind, double slope) {
    LineRules rules = rules_by_slope(kind, s);
    rules.least_facing = 0;
    rules.leave_out_away = true;
    set_slopes(s, slope, 8, rules);
    return rules;
}

}  // namespace

const StripKind suggestive_contour_strips = {
    LineKind::SuggestiveContour,
    [](const LineStyle& style) { return style.shows[LineKind::SuggestiveContour]; },
    [](const LineStyle& style, bool) {
        return rules_of(style, LineKind::SuggestiveContour, style.suggestive_slope);
    }};

const StripKind suggestive_highlight_strips = {
    LineKind::SuggestiveHighlight,
    [](const LineStyle& style) { return style.shows[LineKind::SuggestiveHighlight]; },
    [](const LineStyle& style, bool) {
        return rules_of(style, LineKind::SuggestiveHighlight, 2 * style.suggestive_slope);
    }};

}  // namespace laplacian_lines
