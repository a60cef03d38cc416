// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "views/drawn_view.h"

namespace line_drawing {

inline const Eigen::Vector2d& position_of(const Eigen::Vector2d& point) {
    return point;
}
inline const Eigen::Vector2d& position_of(const DrawnPoint& point) {
    return point.position;
}
inline Eigen::Vector2d between(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double t) {
    return a + t * (b - a);
}

/// With points at most `step` apart and no repeated ones, which have no direction.
template <class Point>
std::vector<Point> refine(const std::vector<Point>& points, double step) {
    std::vector<Point> result;
    for (const Point& p : points) {
        if (!result.empty()) {
            const Point from = result.back();
            const double pieces = std::ceil((position_of(p) - position_of(from)).norm() / step);
            if (!(pieces > 0)) continue;
            for (double i = 1; i < pieces; ++i)
                result.push_back(between(from, p, i / pieces));
        }
        result.push_back(p);
    }
    return result;
}

/// Has a ring, which ends with a copy of its first element, begin at another one.
template <class Ring>
void begin_at(std::size_t place, Ring& ring) {
    ring.pop_back();
    std::rotate(ring.begin(), ring.begin() + std::ptrdiff_t(place), ring.end());
    ring.push_back(ring.front());
}

}  // namespace line_drawing
