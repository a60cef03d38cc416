// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/thresholds.h"

#include <algorithm>
#include <cmath>

namespace laplacian_lines {
namespace {

constexpr float kLeastApparent = 0.02f;   // D; least length of apparent ridges of least curvature
constexpr float kLeastFullSlope = 1e-6f;  // weights are divided by it
// How far above a kind's least slope its lines have their full width, in least slopes.
constexpr float kFullPhotic = 12, kFullSuggestive = 8, kFullApparent = 6;
constexpr float kConcaveThinning = 0.1f;  // cosine, see LineRules

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

/// Lengths and curvatures vary less than slopes, by the square root; the ridge angle by the eighth.
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

namespace {

LineRules contour_rules(const LineStyle& s) {
    LineRules rules;
    rules.least_length = float(s.shortest_contour);
    rules.concave_thinning = kConcaveThinning;
    rules.smoothing_passes = smoothing_passes(s.line_smoothing);
    return rules;
}

/// What kinds that are judged by slopes have in common: all but the kinds' own thresholds.
LineRules rules_by_slope(const LineStyle& s) {
    LineRules rules;
    rules.drop_featureless = s.shows[LineKind::Crease];
    rules.use_slope = true;
    rules.whole = s.whole_lines;
    rules.least_length = Thresholds(s).shortest_line;
    rules.fading = float(s.fading);
    rules.smoothing_passes = smoothing_passes(s.line_smoothing);
    rules.end_length = float(s.end_length);
    if (s.shows[LineKind::Contour]) rules.contour_clearance = float(s.contour_clearance);
    return rules;
}

/// Slopes of a kind with a least slope of a segment as its one option. A segment has its full width
/// `full` above that, whatever the detail.
void set_slopes(float least, float full, LineRules& rules) {
    rules.segment_slope = least;
    rules.line_slope = 2 * least;
    rules.full_slope = std::max(full, kLeastFullSlope);
}

/// L. Zhang, Y. He, X. Xie, W. Chen, "Laplacian Lines for Real-Time Shape Illustration"; what
/// differs from the paper is said at the members of LineStyle.
LineRules laplacian_rules(const LineStyle& s, bool light_at_eye) {
    const Thresholds thresholds(s);
    LineRules rules = rules_by_slope(s);
    rules.least_gradient = thresholds.gradient;
    rules.least_facing = float(s.least_facing);
    rules.reject_phantoms = s.reject_phantoms;
    rules.concave_only = s.single_strokes;
    rules.least_concavity = float(s.least_concavity);
    rules.leave_out_convex = s.single_strokes && s.fading <= kMostFadingOfConvex;
    rules.segment_slope = thresholds.segment_slope;
    rules.line_slope = thresholds.line_slope;
    rules.full_slope = thresholds.full_slope;
    rules.least_strength = thresholds.strength;
    if (!light_at_eye) rules.contour_clearance = 0;
    rules.leave_out_away = rules.contour_clearance > 0;
    return rules;
}

/// X. Xie et al., "An Effective Illustrative Visualization Framework Based on Photic Extremum Lines
/// (PELs)", 2007. Those of Laplacian lines, but for the slope: −d²‖∇I‖/dg² h_e^1.5, g along ∇I.
LineRules photic_rules(const LineStyle& s, bool light_at_eye) {
    LineRules rules = laplacian_rules(s, light_at_eye);
    set_slopes(Thresholds(s).photic_slope, kFullPhotic * float(s.photic_slope), rules);
    return rules;
}

/// D. DeCarlo, A. Finkelstein, S. Rusinkiewicz, A. Santella, "Suggestive Contours for Conveying
/// Shape" (2003); D. DeCarlo, S. Rusinkiewicz, "Highlight Lines for Conveying Shape" (2007). The
/// slope is the derivative of the radial curvature towards the eye, over the cosine of normal and
/// view, times h_e, all to the power 1.5. `times`: of a suggestive contour's least slope.
LineRules suggestive_rules(const LineStyle& s, float times) {
    LineRules rules = rules_by_slope(s);
    rules.least_facing = 0;
    rules.leave_out_away = true;
    set_slopes(times * Thresholds(s).suggestive_slope,
               kFullSuggestive * times * float(s.suggestive_slope), rules);
    return rules;
}

/// T. Judd, F. Durand, E. Adelson, "Apparent Ridges for Line Drawing", 2007. The gradient is q1·D,
/// the slope −d²q1/dr² h_e^1.5.
LineRules apparent_rules(const LineStyle& s) {
    const Thresholds thresholds(s);
    LineRules rules = rules_by_slope(s);
    rules.least_gradient = thresholds.apparent_curvature;
    rules.least_facing = 0;
    rules.leave_out_away = true;
    set_slopes(thresholds.apparent_slope, kFullApparent * float(s.apparent_slope), rules);
    rules.least_strength = thresholds.apparent_strength;
    return rules;
}

}  // namespace

LineRules strip_rules(LineKind kind, const LineStyle& style, bool light_at_eye) {
    switch (kind) {
        case LineKind::Contour:
            return contour_rules(style);
        case LineKind::SuggestiveContour:
            return suggestive_rules(style, 1);
        case LineKind::SuggestiveHighlight:
            return suggestive_rules(style, 2);
        case LineKind::PhoticExtremum:
            return photic_rules(style, light_at_eye);
        case LineKind::ApparentRidge:
            return apparent_rules(style);
        default:
            return laplacian_rules(style, light_at_eye);
    }
}

}  // namespace laplacian_lines
