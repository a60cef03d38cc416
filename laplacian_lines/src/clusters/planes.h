// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace laplacian_lines {

/// A homogeneous point in local coordinates, scaled so that n·(eye − w p) is about in [−1, 1].
struct LocalEye {
    Eigen::Vector3f eye;
    float w;

    Eigen::Vector3f towards(const Eigen::Vector3f& p) const { return eye - w * p; }
};

/// Planes N·(e − w p) = 0 in the homogeneous eye (e, w): N and N·p, one array for each number, so
/// that a pass over all is vectorized.
struct Planes {
    std::vector<float> x, y, z, offset;

    std::size_t size() const { return x.size(); }
    void resize(std::size_t n) {
        for (auto* values : {&x, &y, &z, &offset})
            values->resize(n);
    }
    void set(std::size_t i, const Eigen::Vector3d& normal, const Eigen::Vector3d& p) {
        x[i] = float(normal.x());
        y[i] = float(normal.y());
        z[i] = float(normal.z());
        offset[i] = float(normal.dot(p));
    }

    /// values[i] = N·(e − w p) of plane i, positive if its front is seen.
    void evaluate(const LocalEye& eye, std::vector<float>& values) const {
        const float ex = eye.eye.x(), ey = eye.eye.y(), ez = eye.eye.z(), w = eye.w;
        values.resize(size());
        for (std::size_t i = 0; i < size(); ++i)
            values[i] = x[i] * ex + y[i] * ey + z[i] * ez - w * offset[i];
    }
};

}  // namespace laplacian_lines
