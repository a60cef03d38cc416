// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fixed/zero_lines.h"

namespace laplacian_lines {

/// The direction in a tangent plane in which C(g, g, g) is largest.
struct SteepestBend {
    Eigen::Vector2f direction = Eigen::Vector2f::Zero();  ///< g in the frame of C, unit
    float slope = 0;  ///< C(g, g, g); 0: none is clearly the largest
};
SteepestBend steepest_bend(const Eigen::Vector4f& derivative);

/// Zeros of II(g, g), g the direction in which C(g, g, g) is largest, along which the curvature
/// changes fastest: M. Kolomenkin, I. Shimshoni, A. Tal: "Demarcating Curves for Shape
/// Illustration", SIGGRAPH Asia 2008. g points from hollow to bulging; no curve passes triangles in
/// which it turns by more than 45 degrees. The value of a point is C(g, g, g) h_e in degrees. None
/// without Field::has_derivatives(). Any number of threads gives the same.
ZeroLines find_demarcating_curves(const ExtractorData& data,
                                  const std::vector<PlacedCluster>& placed);

/// In D.
constexpr float kLeastDemarcatingLength = 0.02f;

}  // namespace laplacian_lines
