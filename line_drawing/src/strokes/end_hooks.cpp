// SPDX-License-Identifier: GPL-3.0-or-later
#include "strokes/end_hooks.h"

#include <algorithm>

#include "strokes/drawn_lines.h"
#include "strokes/refining.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;

// in pens
constexpr double longest_hook = 6;  // 1.5 √h
constexpr double line_reach = 4;    // over which the direction of the line before it is taken
constexpr double same_place = 0.5;
constexpr double step = 0.5;

constexpr double hook_cosine = 0.5;  // of 60°

/// The point from which on the line bends aside most; its last one if it does not.
std::size_t beginOfHook(const std::vector<DrawnPoint>& points, double pen) {
    const std::size_t last = points.size() - 1;
    std::size_t begin = last;
    double least = hook_cosine, length = 0;
    for (std::size_t i = last - 1; i > 0; --i) {
        length += (points[i + 1].position - points[i].position).norm();
        if (length > longest_hook * pen) break;
        std::size_t before = i;
        while (before > 0 &&
               (points[i].position - points[before].position).norm() < line_reach * pen)
            --before;
        const Vector2d along = (points[i].position - points[before].position).stableNormalized();
        const Vector2d hook = (points[last].position - points[i].position).stableNormalized();
        if (along.dot(hook) >= least) continue;
        least = along.dot(hook);
        begin = i;
    }
    return begin;
}

}  // namespace

void cutHooks(std::vector<DrawnLine>& lines, double pen) {
    DrawnLines all(longest_hook * pen);
    for (std::size_t i = 0; i < lines.size(); ++i)
        all.add(positionsOf(lines[i]), i);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        DrawnLine& line = lines[i];
        if (!isInner(line) || line.closed || lengthOf(line.points) < 2 * longest_hook * pen)
            continue;
        std::vector<DrawnPoint> points = refine(line.points, step * pen);
        for (int end = 0; end < 2; ++end) {
            std::reverse(points.begin(), points.end());
            if (!all.nearestOn(points.back().position, i, same_place * pen))
                points.resize(beginOfHook(points, pen) + 1);
        }
        line.points = std::move(points);
    }
}

}  // namespace line_drawing
