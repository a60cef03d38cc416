// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

namespace benchmarks {

/// In the plane of a picture, mm, x to the right and y up.
using PlanePoint = Eigen::Vector2d;
using PlaneLine = std::vector<PlanePoint>;
using PlaneLines = std::vector<PlaneLine>;

/// How the axes of a picture lie in the coordinates of a mesh, orthonormal.
struct PlaneFrame {
    Eigen::Vector3d right, up, viewer;  ///< the last one towards the viewer

    PlanePoint project(const Eigen::Vector3d& p) const { return {p.dot(right), p.dot(up)}; }
};

/// Calls use(point, direction, length) for pieces of at most `step`, at their middles.
template <class Use>
void for_each_piece(const PlaneLine& line, double step, Use use) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const PlanePoint way = line[i + 1] - line[i];
        const double length = way.norm();
        if (!(length > 0)) continue;
        const int count = std::max(1, int(std::ceil(length / step)));
        for (int k = 0; k < count; ++k)
            use(PlanePoint(line[i] + way * ((k + 0.5) / count)), PlanePoint(way / length),
                length / count);
    }
}

}  // namespace benchmarks
