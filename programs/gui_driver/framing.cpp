// SPDX-License-Identifier: GPL-3.0-or-later
#include "framing.h"

#include <algorithm>
#include <limits>

namespace driver {
namespace {

/// An axis of the picture, 0 or 1: p is within half the window's size t at a distance of 1 if
/// |p[axis] - eye[axis]| <= t (eye.z - p.z).
class Axis {
public:
    Axis(const std::vector<Eigen::Vector3d>& points, int axis) : points_(points), axis_(axis) {}

    /// How near the eye may come.
    double leastDepth(double half_size) const {
        double left = -std::numeric_limits<double>::infinity(), right = left;
        for (const Eigen::Vector3d& p : points_) {
            right = std::max(right, p[axis_] + half_size * p.z());
            left = std::max(left, -p[axis_] + half_size * p.z());
        }
        return (left + right) / (2 * half_size);
    }

    /// Where the eye sees the outermost points on both sides at the same angle. Which these are
    /// changes as the eye moves, since near ones shift faster: iterate until they stay.
    double middle(double depth) const {
        constexpr int most_rounds = 20;
        double eye = 0;
        for (int round = 0; round < most_rounds; ++round) {
            const Eigen::Vector3d *left = &points_.front(), *right = left;
            const auto tangent = [&](const Eigen::Vector3d& p) {
                return (p[axis_] - eye) / (depth - p.z());
            };
            for (const Eigen::Vector3d& p : points_) {
                if (tangent(p) < tangent(*left)) left = &p;
                if (tangent(p) > tangent(*right)) right = &p;
            }
            const double l = 1 / (depth - left->z()), r = 1 / (depth - right->z());
            const double next = ((*left)[axis_] * l + (*right)[axis_] * r) / (l + r);
            if (next == eye) break;
            eye = next;
        }
        return eye;
    }

private:
    const std::vector<Eigen::Vector3d>& points_;
    int axis_;
};

}  // namespace

double leastDistance(const std::vector<Eigen::Vector3d>& points, const Window& window,
                     double nearest) {
    double least = std::max(Axis(points, 0).leastDepth(window.half_width),
                            Axis(points, 1).leastDepth(window.half_height));
    for (const Eigen::Vector3d& p : points)
        least = std::max(least, p.z() / (1 - nearest));
    return least;
}

Eigen::Vector3d centredEye(const std::vector<Eigen::Vector3d>& points, double z) {
    return {Axis(points, 0).middle(z), Axis(points, 1).middle(z), z};
}

ParallelFrame parallelFrame(const std::vector<Eigen::Vector3d>& points, const Window& window) {
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector3d& p : points)
        box.extend(p.head<2>());
    return {
        box.center(),
        std::max(box.sizes().x() / window.half_width, box.sizes().y() / window.half_height) / 2};
}

}  // namespace driver
