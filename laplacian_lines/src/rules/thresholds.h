// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "laplacian_lines/field.h"
#include "laplacian_lines/line_style.h"
#include "rules/line_rules.h"

namespace laplacian_lines {

/// A style's thresholds, with its detail applied. Only kernels of line_drawing read that as well.
struct Thresholds {
    explicit Thresholds(const LineStyle& style);

    float gradient, strength;  ///< of Laplacian lines
    float segment_slope, line_slope;
    float full_slope;     ///< above a detail of 50 less: what is faint is drawn in full
    float shortest_line;  ///< D
    float ridge_angle;    ///< degrees
    float demarcation;    ///< degrees
    float suggestive_slope, photic_slope;
    float apparent_curvature, apparent_strength, apparent_slope;
};

/// Which zeros of a kind that is found at each redraw a style shows, without what the mesh adds.
/// Laplacian and photic lines keep clear of contours only if the light is at the eye.
LineRules strip_rules(LineKind kind, const LineStyle& style, bool light_at_eye);

/// Up to this fading, no line that is concave towards the light passes where is_convex() holds.
constexpr double kMostFadingOfConvex = 1;

/// Whether w·Sw ≥ c ‖w‖ ‖Sw‖, c = kMostFadingOfConvex / 4, for all tangent vectors w: the surface
/// is convex whatever the light. The least cosine between w and Sw is 2√(k₁k₂)/(k₁ + k₂).
inline bool is_convex(const ShapeOperator& s) {
    constexpr float c = float(kMostFadingOfConvex / 4);
    const float trace = s.trace();  // k₁ + k₂
    const float product =
        s.xx * s.yy + s.yy * s.zz + s.zz * s.xx - s.xy * s.xy - s.yz * s.yz - s.xz * s.xz;  // k₁k₂
    return trace > 0 && 4 * product >= c * c * trace * trace;
}

/// Linear from 0 at `from` to 1 at `to`; a step if they are equal.
inline float rise(float v, float from, float to) {
    if (v >= to) return 1;
    return v > from ? (v - from) / (to - from) : 0;
}

/// Opacity of a point that would double a contour nearby: 1 from `clearance` on (D, in the
/// picture), 0 up to half of it. To first order the contour is I/‖∇I‖ away, foreshortened by half
/// the point's cosine. facing: I = n·l; gradient: ‖∇I‖·D, not 0.
inline float clearance_opacity(float facing, float gradient, float clearance) {
    if (!(clearance > 0)) return 1;
    const float distance = facing * std::abs(facing) / (2 * gradient);
    return std::clamp(2 * distance / clearance - 1, 0.f, 1.f);
}

}  // namespace laplacian_lines
