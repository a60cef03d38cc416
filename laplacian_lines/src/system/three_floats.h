// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace laplacian_lines {

// The same bits everywhere: on aarch64 Eigen adds three floats in another order, and functions of
// floats differ between C libraries; those of doubles do in the last bits, which rounding removes.

inline float dot(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
    return a.x() * b.x() + (a.y() * b.y() + a.z() * b.z());
}

inline float squared_length_of(const Eigen::Vector3f& v) {
    return dot(v, v);
}

inline float length_of(const Eigen::Vector3f& v) {
    return std::sqrt(dot(v, v));
}

/// Zero of a zero vector.
inline Eigen::Vector3f unit(const Eigen::Vector3f& v) {
    const float square = dot(v, v);
    return square > 0 ? Eigen::Vector3f(v / std::sqrt(square)) : v;
}

inline float sine_of(float angle) {
    return float(std::sin(double(angle)));
}

inline float cosine_of(float angle) {
    return float(std::cos(double(angle)));
}

/// Of (x, y), radians.
inline float arc_tangent(float y, float x) {
    return float(std::atan2(double(y), double(x)));
}

}  // namespace laplacian_lines
