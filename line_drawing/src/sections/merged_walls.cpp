// SPDX-License-Identifier: GPL-3.0-or-later
#include "sections/wall_area.h"

#include <algorithm>

#include "planes/cutting.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;

constexpr int row_count = 256;         // at which areas are measured
constexpr double least_overlap = .01;  // of the smaller of two walls

Eigen::AlignedBox2d boxOf(const Wall& wall) {
    Eigen::AlignedBox2d box;
    for (const auto& loop : wall)
        for (const Vector2d& p : loop)
            box.extend(p);
    return box;
}

/// The length that both cover on a line, each between pairs of crossings.
double sharedLength(const std::vector<double>& a, const std::vector<double>& b) {
    double length = 0;
    for (std::size_t i = 0, k = 0; i + 1 < a.size() && k + 1 < b.size();) {
        length += std::max(0., std::min(a[i + 1], b[k + 1]) - std::max(a[i], b[k]));
        (a[i + 1] < b[k + 1] ? i : k) += 2;
    }
    return length;
}

/// The area that two walls share in a box; the whole of a wall with itself.
double sharedArea(const Wall& a, const Wall& b, const Eigen::AlignedBox2d& box) {
    const double height = box.sizes().y() / row_count;
    double area = 0;
    for (int row = 0; row < row_count; ++row) {
        const double y = box.min().y() + (row + .5) * height;
        area += height * sharedLength(crossingsAt(a, Vector2d::UnitX(), y),
                                      crossingsAt(b, Vector2d::UnitX(), y));
    }
    return area;
}

bool overlap(const Wall& a, const Wall& b) {
    const Eigen::AlignedBox2d box_a = boxOf(a), box_b = boxOf(b);
    const Eigen::AlignedBox2d both = box_a.intersection(box_b);
    if (both.isEmpty() || both.volume() == 0) return false;
    const double smaller = std::min(sharedArea(a, a, box_a), sharedArea(b, b, box_b));
    return sharedArea(a, b, both) > least_overlap * smaller;
}

/// For each object, the first one whose wall merges with its own.
std::vector<std::size_t> groupsOf(const std::vector<CutObject>& objects) {
    std::vector<std::size_t> groups;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        groups.push_back(i);
        for (std::size_t k = 0; k < i; ++k) {
            if (groups[k] == groups[i] || !overlap(objects[i].wall, objects[k].wall)) continue;
            const auto [first, second] = std::minmax({groups[i], groups[k]});
            std::replace(groups.begin(), groups.end(), std::size_t(second), std::size_t(first));
        }
    }
    return groups;
}

}  // namespace

void addWalls(const std::vector<CutObject>& objects, DrawnView& drawn) {
    const std::vector<std::size_t> groups = groupsOf(objects);
    for (std::size_t first = 0; first < objects.size(); ++first) {
        if (groups[first] != first) continue;
        MergedWalls& merged = drawn.walls.emplace_back();
        for (std::size_t i = first; i < objects.size(); ++i) {
            if (groups[i] != first) continue;
            merged.push_back(objects[i].wall);
            std::vector<DrawnLine> lines = objects[i].lines;
            for (std::size_t k = first; k < objects.size(); ++k)
                if (k != i && groups[k] == first)
                    lines = withoutPartsIn(WallArea(objects[k].wall), lines);
            drawn.lines.insert(drawn.lines.end(), lines.begin(), lines.end());
        }
    }
}

}  // namespace line_drawing
