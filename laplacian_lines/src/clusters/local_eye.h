// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace laplacian_lines {

/// A homogeneous point in local coordinates, scaled so that n·(eye − w p) is about in [−1, 1].
struct LocalEye {
    Eigen::Vector3f eye;
    float w;

    Eigen::Vector3f towards(const Eigen::Vector3f& p) const { return eye - w * p; }
};

}  // namespace laplacian_lines
