// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/line_rules.h"

#include <cmath>

#include "laplacian_lines/line_set.h"
#include "laplacian_lines/line_style.h"
#include "rules/convexity.h"

namespace laplacian_lines {
double threshold_factor(double detail) {
    // Fitted to the number of lines on the Stanford bunny and dragon, igea and the armadillo.
    const double x = detail / 50 - 1;  // -1..1
    return std::exp2(x < 0 ? 3.5 * std::pow(-x, 1.6) : -5 * std::pow(x, 1.3));
}

int smoothing_passes(double deviation) {
    return int(std::lround(2 * deviation * deviation));  // a pass has a variance of 1/2
}

LineRules laplacian_rules(const LineStyle& s) {
    const double factor = threshold_factor(s.detail);
    LineRules rules;
    rules.kind = LineKind::Laplacian;
    rules.least_gradient = float(factor * s.gradient_threshold);
    rules.least_facing = float(s.least_facing);
    rules.reject_phantoms = s.reject_phantoms;
    rules.concave_only = s.single_strokes;
    rules.leave_out_convex = s.single_strokes && s.fading <= kMostFadingOfConvex;
    rules.use_slope = true;
    rules.segment_slope = float(factor * s.segment_slope);
    rules.line_slope = float(factor * s.line_slope);
    rules.full_slope = float(s.full_slope);
    rules.least_strength = float(factor * s.strength_threshold);
    rules.least_length = float(std::sqrt(factor) * s.shortest_line);
    rules.fading = float(s.fading);
    rules.smoothing_passes = smoothing_passes(s.line_smoothing);
    rules.end_length = float(s.end_length);
    rules.contour_clearance = s.shows[LineKind::Contour] ? float(s.contour_clearance) : 0;
    rules.leave_out_away = rules.contour_clearance > 0;
    return rules;
}

void follow_no_contours(LineRules& rules) {
    rules.contour_clearance = 0;
    rules.leave_out_away = false;
}

LineRules contour_rules(const LineStyle& s) {
    LineRules rules;
    rules.kind = LineKind::Contour;
    rules.least_length = float(s.shortest_contour);
    rules.concave_thinning = 0.1f;
    rules.smoothing_passes = smoothing_passes(s.line_smoothing);
    return rules;
}

}  // namespace laplacian_lines
