// SPDX-License-Identifier: GPL-3.0-or-later
#include "strokes/strokes.h"

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

constexpr double longest_lead = 3;
constexpr double direction_reach = 3;  // of an end
constexpr double shift_reach = 4;      // over which a line follows its end

constexpr double hook_cosine = 0.5;   // of 60°
constexpr double lead_cosine = 0.7;   // of 45°
constexpr double least_weight = 0.5;  // of ends that are led on; fainter ones taper off

/// The point from which the line bends aside most; the last one if it does not.
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
    const DrawnLines all = allOf(lines, pen);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        DrawnLine& line = lines[i];
        if (!isInner(line) || line.closed || lengthOf(line.points) < 2 * longest_hook * pen)
            continue;
        std::vector<DrawnPoint> points = refine(line.points, step * pen);
        for (int end = 0; end < 2; ++end) {
            std::reverse(points.begin(), points.end());
            if (!all.isNear(points.back().position, i, same_place * pen))
                points.resize(beginOfHook(points, pen) + 1);
        }
        line.points = std::move(points);
    }
}

std::vector<MetEnd> joinEnds(std::vector<DrawnLine>& lines, double pen) {
    const DrawnLines all = allOf(lines, longest_lead * pen);
    std::vector<MetEnd> met;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::vector<DrawnPoint>& points = lines[i].points;
        if (!isInner(lines[i]) || lines[i].closed || points.size() < 2) continue;
        for (const bool is_last : {false, true}) {
            const DrawnPoint end = is_last ? points.back() : points.front();
            const auto place = all.nearestOn(end.position, i, longest_lead * pen);
            if (!place) continue;
            const Vector2d way = place->position - end.position;
            if (way.norm() > same_place * pen) {
                const Vector2d outwards = outwardsAt(points, is_last, direction_reach * pen);
                if (end.weight < least_weight || outwards.dot(way) < lead_cosine * way.norm())
                    continue;
                points.insert(is_last ? points.end() : points.begin(),
                              {place->position, end.weight, end.node, false});
            }
            met.push_back({i, is_last, place->line});
        }
    }
    return met;
}

void followMet(const std::vector<MetEnd>& ends, double pen, std::vector<DrawnLine>& lines) {
    const DrawnLines all = allOf(lines, longest_lead * pen);
    for (const MetEnd& end : ends) {
        std::vector<DrawnPoint>& points = lines[end.line].points;
        const Vector2d at = (end.is_last ? points.back() : points.front()).position;
        const auto place = all.nearestOn(at, end.line, pen);
        if (place && place->line == end.met)
            shiftEnd(points, end.is_last, place->position - at, shift_reach * pen);
    }
}

}  // namespace line_drawing
