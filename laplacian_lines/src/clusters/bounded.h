// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace laplacian_lines {

// Whatever a caller's field holds, floats can take powers of what is kept of it.
constexpr double kLargestCurvature = 1e8;  ///< S·D

/// Within ±limit; what is not a number is 0.
inline double bounded(double x, double limit) {
    return std::isnan(x) ? 0 : std::clamp(x, -limit, limit);
}
inline Eigen::Vector3d bounded(const Eigen::Vector3f& v, double factor, double limit) {
    return (v.cast<double>() * factor).unaryExpr([=](double x) { return bounded(x, limit); });
}

}  // namespace laplacian_lines
