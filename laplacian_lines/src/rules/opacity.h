// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace laplacian_lines {

/// Linear from 0 at `from` to 1 at `to`; a step if they are equal.
inline float rise(float v, float from, float to) {
    if (v >= to) return 1;
    return v > from ? (v - from) / (to - from) : 0;
}

/// Opacity of a point that would double a contour nearby: 1 from `clearance` on (D, in the
/// picture), 0 up to half of it. To first order the contour is I/‖∇I‖ away, foreshortened by half
/// the point's cosine. facing: I = n·l; gradient: ‖∇I‖·D.
inline float clearance_opacity(float facing, float gradient, float clearance) {
    if (!(clearance > 0)) return 1;
    const float distance = facing * std::abs(facing) / (2 * gradient);
    return std::clamp(2 * distance / clearance - 1, 0.f, 1.f);
}

}  // namespace laplacian_lines
