// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/field.h"

namespace laplacian_lines {

/// Up to this fading, no line that is concave towards the light passes where is_convex() holds.
constexpr double kMostFadingOfConvex = 1;

/// Whether w·Sw ≥ c ‖w‖ ‖Sw‖, c = kMostFadingOfConvex / 4, for all tangent vectors w: the surface
/// is convex whatever the light. The least cosine between w and Sw is 2√(k₁k₂)/(k₁ + k₂).
inline bool is_convex(const ShapeOperator& s) {
    constexpr float c = float(kMostFadingOfConvex / 4);
    const float trace = s.xx + s.yy + s.zz;  // k₁ + k₂
    const float product =
        s.xx * s.yy + s.yy * s.zz + s.zz * s.xx - s.xy * s.xy - s.yz * s.yz - s.xz * s.xz;  // k₁k₂
    return trace > 0 && 4 * product >= c * c * trace * trace;
}

}  // namespace laplacian_lines
