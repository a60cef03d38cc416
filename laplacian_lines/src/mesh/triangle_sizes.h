// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace laplacian_lines {

inline bool has_three_corners(const Triangle& t) {
    return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
}

/// Twice the area of a triangle times its unit normal.
inline Eigen::Vector3d area_vector(const std::vector<Eigen::Vector3d>& positions,
                                   const Triangle& t) {
    const Eigen::Vector3d& a = positions[t[0]];
    return (positions[t[1]] - a).cross(positions[t[2]] - a);
}

/// The square of a triangle's longest side.
inline double longest_squared(const std::vector<Eigen::Vector3d>& positions, const Triangle& t) {
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k)
        longest = std::max(longest, (positions[t[k]] - positions[t[(k + 1) % 3]]).squaredNorm());
    return longest;
}

/// A triangle's height above its longest side; 0 if that has no length.
inline double height_of(const std::vector<Eigen::Vector3d>& positions, const Triangle& t) {
    const double longest = std::sqrt(longest_squared(positions, t));
    return longest > 0 ? area_vector(positions, t).norm() / longest : 0;
}

}  // namespace laplacian_lines
