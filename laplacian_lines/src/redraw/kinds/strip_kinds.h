// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "redraw/extraction_task.h"
#include "rules/thresholds.h"

namespace laplacian_lines {

/// What a redraw has to know of a kind before it begins. The kind's form at a vertex and its test
/// at a crossing are beside it, in ..._simd.h.
struct StripKind {
    LineKind kind;
    /// Whether the style shows lines of this kind that are zeros.
    bool (*is_wanted)(const LineStyle&);
    /// Lines of a light that is not at the eye follow no contours.
    LineRules (*rules)(const LineStyle&, bool light_at_eye);
};

/// What rules of kinds that are judged by slopes have in common: all but the kinds' own thresholds.
LineRules rules_by_slope(LineKind kind, const LineStyle& style);
/// Slopes of a kind with a least slope of a segment as its one option. A segment has its full width
/// `full` above that, whatever the detail.
void set_slopes(float least, float full, LineRules& rules);

/// The rules of occluding contours.
LineRules contour_rules(const LineStyle& style);

extern const StripKind laplacian_line_strips;  ///< laplacian_lines.cpp
extern const StripKind contour_strips;         ///< contours.cpp
extern const StripKind suggestive_contour_strips, suggestive_highlight_strips;
extern const StripKind photic_extremum_strips;  ///< photic_extrema.cpp
extern const StripKind apparent_ridge_strips;   ///< apparent_ridges.cpp

/// In the order of kStripKinds.
inline std::array<const StripKind*, kStripKindCount> strip_kinds() {
    return {&laplacian_line_strips,       &contour_strips,         &suggestive_contour_strips,
            &suggestive_highlight_strips, &photic_extremum_strips, &apparent_ridge_strips};
}

}  // namespace laplacian_lines
