// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>

namespace line_renderer {

/// Length in eye coordinates of a length in mesh coordinates, the mean over directions if the
/// layer's transformation scales them differently.
inline double meanScale(const Eigen::Matrix4d& to_eye) {
    return std::cbrt(std::abs(to_eye.topLeftCorner<3, 3>().determinant()));
}

}  // namespace line_renderer
