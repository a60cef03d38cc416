// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace laplacian_lines {

/// A right-handed orthonormal frame (u, v, n).
struct TangentFrame {
    Eigen::Vector3f u, v;

    /// Components of a vector along u and v.
    Eigen::Vector2f operator()(const Eigen::Vector3f& vector) const {
        return {u.dot(vector), v.dot(vector)};
    }
};

/// The frame of Field::smooth_curvatures and curvature_derivatives: a function of the unit normal
/// alone, which jumps where n.z changes sign. T. Duff et al., "Building an Orthonormal Basis,
/// Revisited", Journal of Computer Graphics Techniques 6(1), 2017.
inline TangentFrame tangent_frame(const Eigen::Vector3f& n) {
    const float sign = std::copysign(1.f, n.z());
    const float a = -1 / (sign + n.z()), b = n.x() * n.y() * a;
    return {{1 + sign * n.x() * n.x() * a, sign * b, -sign * n.x()},
            {b, sign + n.y() * n.y() * a, -n.y()}};
}

}  // namespace laplacian_lines
