// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/thresholds.h"

#include <algorithm>
#include <cmath>

#include "rules/line_rules.h"

namespace laplacian_lines {
namespace {

/// D; for the least curvature.
constexpr float kLeastApparent = 0.02f;
constexpr float kLeastFullSlope = 1e-6f;  // weights are divided by it

/// 1 at 50, falling: fitted to the number of lines on the Stanford bunny and dragon, igea and the
/// armadillo.
double threshold_factor(double detail) {
    const double x = detail / 50 - 1;  // -1..1
    return std::exp2(x < 0 ? 3.5 * std::pow(-x, 1.6) : -5 * std::pow(x, 1.3));
}

}  // namespace

int smoothing_passes(double deviation) {
    return int(std::lround(2 * deviation * deviation));  // a pass has a variance of 1/2
}

/// Lengths and curvatures vary less than slopes, by the square root; angles by the eighth.
Thresholds::Thresholds(const LineStyle& style) {
    const double factor = threshold_factor(style.detail);
    const auto slopes = float(factor), curvatures = std::sqrt(slopes);
    gradient = float(factor * style.gradient_threshold);
    strength = float(factor * style.strength_threshold);
    segment_slope = float(factor * style.segment_slope);
    line_slope = float(factor * style.line_slope);
    full_slope = std::max(float(std::min(factor, 1.) * style.full_slope), kLeastFullSlope);
    shortest_line = float(std::sqrt(factor) * style.shortest_line);
    ridge_angle = float(std::pow(factor, 0.125) * style.ridge_angle);
    demarcation = float(factor * style.demarcation);
    suggestive_slope = slopes * float(style.suggestive_slope);
    photic_slope = slopes * float(style.photic_slope);
    apparent_curvature = curvatures * float(style.apparent_curvature);
    apparent_strength = apparent_curvature * kLeastApparent * curvatures;
    apparent_slope = slopes * float(style.apparent_slope);
}

}  // namespace laplacian_lines
