// SPDX-License-Identifier: GPL-3.0-or-later
// Cut walls: the edges of their loops in 256 rows, so that a line is tested against few of them.
// Walls of two objects that overlap by more than a hundredth count as one, without lines inside it.
#include "sections/wall_area.h"

#include <algorithm>

#include "planes/hatching.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;

constexpr std::size_t kRowCount = 256;     // of a wall's edges, and at which its area is measured
constexpr double kLeastOverlap = .01;      // of the smaller of two walls
constexpr double kBorderTolerance = 1e-6;  // of the area's size: tolerance at its border

Eigen::AlignedBox2d box_of(const Wall& wall) {
    Eigen::AlignedBox2d box;
    for (const auto& loop : wall)
        for (const Vector2d& p : loop)
            box.extend(p);
    return box;
}

DrawnPoint point_at(const DrawnPoint& a, const DrawnPoint& b, double t) {
    return t == 0 ? a : t == 1 ? b : between(a, b, t);
}

std::vector<DrawnLine> parts_outside(const WallArea& area, const DrawnLine& line) {
    std::vector<DrawnLine> parts;
    bool goes_on = false, begins_outside = false;
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        const DrawnPoint &a = line.points[i - 1], &b = line.points[i];
        const auto stretches = area.outside(a.position, b.position);
        for (const WallArea::Stretch& stretch : stretches) {
            if (!goes_on || stretch.begin > 0) {
                parts.push_back(with_points(line, {point_at(a, b, stretch.begin)}));
                begins_outside |= i == 1 && stretch.begin == 0;
            }
            parts.back().points.push_back(point_at(a, b, stretch.end));
            goes_on = stretch.end == 1;
        }
        if (stretches.empty()) goes_on = false;
    }
    if (line.closed && begins_outside && goes_on) {
        parts[0].closed = parts.size() == 1;
        if (parts[0].closed) return parts;
        std::vector<DrawnPoint>& last = parts.back().points;
        last.insert(last.end(), parts[0].points.begin() + 1, parts[0].points.end());
        parts.erase(parts.begin());
    }
    return parts;
}

/// The common length of two sets of intervals, each between pairs of crossings.
double shared_length(const std::vector<double>& a, const std::vector<double>& b) {
    double length = 0;
    for (std::size_t i = 0, k = 0; i + 1 < a.size() && k + 1 < b.size();) {
        length += std::max(0., std::min(a[i + 1], b[k + 1]) - std::max(a[i], b[k]));
        (a[i + 1] < b[k + 1] ? i : k) += 2;
    }
    return length;
}

/// The common area of two walls in a box; of a wall with itself, its area.
double shared_area(const Wall& a, const Wall& b, const Eigen::AlignedBox2d& box) {
    const double height = box.sizes().y() / kRowCount;
    double area = 0;
    for (std::size_t row = 0; row < kRowCount; ++row) {
        const double y = box.min().y() + (double(row) + .5) * height;
        area += height * shared_length(crossings_at(a, Vector2d::UnitX(), y),
                                       crossings_at(b, Vector2d::UnitX(), y));
    }
    return area;
}

/// For each object, the first one whose wall merges with its own.
std::vector<std::size_t> groups_of(const std::vector<CutObject>& objects) {
    std::vector<std::size_t> groups;
    std::vector<double> areas(objects.size());  // 0: not measured yet
    const auto area_of = [&](std::size_t i) {
        const Wall& wall = objects[i].wall;
        if (areas[i] == 0) areas[i] = shared_area(wall, wall, box_of(wall));
        return areas[i];
    };
    const auto overlap = [&](std::size_t i, std::size_t k) {
        const Wall &a = objects[i].wall, &b = objects[k].wall;
        const Eigen::AlignedBox2d both = box_of(a).intersection(box_of(b));
        if (both.isEmpty() || both.volume() == 0) return false;
        return shared_area(a, b, both) > kLeastOverlap * std::min(area_of(i), area_of(k));
    };
    for (std::size_t i = 0; i < objects.size(); ++i) {
        groups.push_back(i);
        for (std::size_t k = 0; k < i; ++k) {
            if (groups[k] == groups[i] || !overlap(i, k)) continue;
            const auto [first, second] = std::minmax({groups[i], groups[k]});
            std::replace(groups.begin(), groups.end(), second, first);
        }
    }
    return groups;
}

}  // namespace

WallArea::WallArea(const Wall& loops) {
    const Eigen::AlignedBox2d box = box_of(loops);
    if (box.isEmpty()) return;
    rows_.resize(kRowCount);
    low_ = box.min().y();
    row_height_ = std::max(box.sizes().y() / kRowCount, 1e-12);
    slight_ = kBorderTolerance * box.sizes().norm();
    for (const auto& loop : loops)
        for (std::size_t i = 1; i < loop.size(); ++i) {
            const auto [low, high] = std::minmax({loop[i - 1].y(), loop[i].y()});
            for (std::size_t row = row_of(low); row <= row_of(high); ++row)
                rows_[row].push_back({loop[i - 1], loop[i]});
        }
}

std::size_t WallArea::row_of(double y) const {
    return std::size_t(std::clamp((y - low_) / row_height_, 0., double(kRowCount - 1)));
}

bool WallArea::contains(const Vector2d& point) const {
    if (rows_.empty()) return false;
    bool is_inside = false;
    for (const Edge& edge : rows_[row_of(point.y())]) {
        if ((edge.begin.y() <= point.y()) == (edge.end.y() <= point.y())) continue;
        const double t = (point.y() - edge.begin.y()) / (edge.end.y() - edge.begin.y());
        if (edge.begin.x() + t * (edge.end.x() - edge.begin.x()) > point.x())
            is_inside = !is_inside;
    }
    return is_inside;
}

std::vector<WallArea::Stretch> WallArea::outside(const Vector2d& begin, const Vector2d& end) const {
    std::vector<Stretch> result;
    const std::vector<double> at = crossings(begin, end);
    for (std::size_t i = 1; i < at.size(); ++i) {
        if (encloses(begin + at[i - 1] * (end - begin), begin + at[i] * (end - begin))) continue;
        if (result.empty() || result.back().end != at[i - 1])
            result.push_back({at[i - 1], at[i]});
        else
            result.back().end = at[i];
    }
    return result;
}

/// Where a segment meets the loops, as shares of it: ascending, with 0 and 1.
std::vector<double> WallArea::crossings(const Vector2d& begin, const Vector2d& end) const {
    std::vector<double> at = {0, 1};
    const Vector2d span = end - begin;
    const auto across = [](const Vector2d& a, const Vector2d& b) {
        return a.x() * b.y() - a.y() * b.x();
    };
    const auto [low, high] = std::minmax({begin.y(), end.y()});
    for (std::size_t row = row_of(low); !rows_.empty() && row <= row_of(high); ++row)
        for (const Edge& edge : rows_[row]) {
            const Vector2d side = edge.end - edge.begin;
            const double turn = across(span, side);
            if (turn == 0) continue;
            const double t = across(edge.begin - begin, side) / turn;
            const double u = across(edge.begin - begin, span) / turn;
            if (t > 0 && t < 1 && u >= 0 && u <= 1) at.push_back(t);
        }
    std::sort(at.begin(), at.end());
    at.erase(std::unique(at.begin(), at.end()), at.end());
    return at;
}

/// Whether a segment that meets loops only at its ends is inside, and not along a loop.
bool WallArea::encloses(const Vector2d& begin, const Vector2d& end) const {
    const Vector2d span = (end - begin).stableNormalized(), middle = (begin + end) / 2;
    const Vector2d aside = slight_ * Vector2d(-span.y(), span.x());
    return contains(middle + aside) && contains(middle - aside);
}

std::vector<DrawnLine> without_parts_in(const WallArea& area, const std::vector<DrawnLine>& lines) {
    std::vector<DrawnLine> rest;
    for (const DrawnLine& line : lines)
        for (DrawnLine& part : parts_outside(area, line))
            rest.push_back(std::move(part));
    return rest;
}

void add_walls(std::vector<CutObject> objects, DrawnView& drawn) {
    const std::vector<std::size_t> groups = groups_of(objects);
    for (std::size_t k = 0; k < objects.size(); ++k) {
        if (std::count(groups.begin(), groups.end(), groups[k]) == 1) continue;
        const WallArea area(objects[k].wall);
        for (std::size_t i = 0; i < objects.size(); ++i)
            if (i != k && groups[i] == groups[k])
                objects[i].lines = without_parts_in(area, objects[i].lines);
    }
    for (std::size_t first = 0; first < objects.size(); ++first) {
        if (groups[first] != first) continue;
        MergedWalls& merged = drawn.walls.emplace_back();
        for (std::size_t i = first; i < objects.size(); ++i) {
            if (groups[i] != first) continue;
            merged.push_back(std::move(objects[i].wall));
            drawn.lines.insert(drawn.lines.end(), objects[i].lines.begin(), objects[i].lines.end());
        }
    }
}

}  // namespace line_drawing
