// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/line_style.h"

namespace laplacian_lines {

/// A style's thresholds, with its detail applied. Nothing else reads the detail.
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

}  // namespace laplacian_lines
