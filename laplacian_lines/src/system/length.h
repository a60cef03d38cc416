// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace laplacian_lines {

/// ‖v‖ with the same bits everywhere: in which order Eigen adds up three floats depends on the
/// processor.
inline float length_of(const Eigen::Vector3f& v) {
    return std::sqrt(v.x() * v.x() + (v.y() * v.y() + v.z() * v.z()));
}

}  // namespace laplacian_lines
