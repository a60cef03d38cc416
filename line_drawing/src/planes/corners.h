// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

namespace line_drawing {

/// Simplifies a line of points in the plane or in space: returns the numbers of its corners from
/// `first` on, without `last`. The points between are within `tolerance` of straight lines. D. H.
/// Douglas and T. K. Peucker, "Algorithms for the Reduction of the Number of Points Required to
/// Represent a Digitized Line or its Caricature" (1973).
template <class Point>
std::vector<std::size_t> corners_of(const std::vector<Point>& points, std::size_t first,
                                    std::size_t last, double tolerance) {
    std::vector<std::size_t> corners;
    std::vector<std::pair<std::size_t, std::size_t>> parts = {{first, last}};
    while (!parts.empty()) {
        const auto [begin, end] = parts.back();
        parts.pop_back();
        const Point span = (points[end] - points[begin]).stableNormalized();
        std::size_t farthest = begin;
        double most = tolerance;
        for (std::size_t i = begin + 1; i < end; ++i) {
            const Point p = points[i] - points[begin];
            const double along = std::clamp(span.dot(p), 0., span.dot(points[end] - points[begin]));
            if ((p - along * span).norm() <= most) continue;
            most = (p - along * span).norm();
            farthest = i;
        }
        if (farthest == begin) {
            corners.push_back(begin);
            continue;
        }
        parts.emplace_back(farthest, end);
        parts.emplace_back(begin, farthest);
    }
    return corners;
}

}  // namespace line_drawing
