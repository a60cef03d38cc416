// SPDX-License-Identifier: GPL-3.0-or-later
// Which suggestive contours and highlights a style shows: D. DeCarlo, A. Finkelstein, S.
// Rusinkiewicz, A. Santella, "Suggestive Contours for Conveying Shape" (2003); D. DeCarlo, S.
// Rusinkiewicz, "Highlight Lines for Conveying Shape" (2007).
#include "redraw/kinds/strip_kinds.h"

namespace laplacian_lines {
namespace {

/// The slope is the derivative of the radial curvature towards the eye, over the cosine of normal
/// and view, times h_e, all to the power 1.5. `times`: of a suggestive contour's least slope.
LineRules rules_of(const LineStyle& s, LineKind kind, float times) {
    LineRules rules = rules_by_slope(kind, s);
    rules.least_facing = 0;
    rules.leave_out_away = true;
    set_slopes(times * Thresholds(s).suggestive_slope, 8 * times * float(s.suggestive_slope),
               rules);
    return rules;
}

}  // namespace

const StripKind suggestive_contour_strips = {
    LineKind::SuggestiveContour,
    [](const LineStyle& style) { return style.shows[LineKind::SuggestiveContour]; },
    [](const LineStyle& style, bool) { return rules_of(style, LineKind::SuggestiveContour, 1); }};

const StripKind suggestive_highlight_strips = {
    LineKind::SuggestiveHighlight,
    [](const LineStyle& style) { return style.shows[LineKind::SuggestiveHighlight]; },
    [](const LineStyle& style, bool) { return rules_of(style, LineKind::SuggestiveHighlight, 2); }};

}  // namespace laplacian_lines
