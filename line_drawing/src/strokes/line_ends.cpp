// SPDX-License-Identifier: GPL-3.0-or-later
// Ends of inner lines: hooks go, what heads for another line is led to it, the others become
// points.
#include "strokes/strokes.h"

#include <algorithm>

#include "strokes/drawn_lines.h"
#include "strokes/refining.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;

// of inner lines, in pens
constexpr double kLongestHook = 6;  // 1.5 √h
constexpr double kLineReach = 4;    // over which directions before and after a bend are taken
constexpr double kSamePlace = 0.5;
constexpr double kStep = 0.5;

constexpr double kLongestLead = 3;
constexpr double kDirectionReach = 3;  // of an end
constexpr double kShiftReach = 4;      // over which a line follows its end
constexpr double kPointLength = 6;     // at most a third of the line

constexpr double kLongestFaintHook = 1 / 3.;  // of the line
constexpr double kFaint = 0.75;               // of the mean weight of the line before a hook
constexpr double kHookCosine = 0.5;           // of 60°
constexpr double kLeadCosine = 0.7;           // of 45°
constexpr double kLeastWeight = 0.5;          // of ends that are led on; fainter ones taper off

/// Whether what follows a point is fainter than what is before it.
bool is_faint(const std::vector<DrawnPoint>& points, std::size_t at) {
    const auto mean = [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i)
            sum += points[i].weight;
        return sum / double(end - begin);
    };
    return mean(at, points.size()) < kFaint * mean(0, at);
}

/// The point from which the line bends aside most; the last one if it does not.
std::size_t begin_of_hook(const std::vector<DrawnPoint>& points, double pen) {
    const std::size_t last = points.size() - 1;
    const double longest = std::max(kLongestHook * pen, kLongestFaintHook * length_of(points));
    std::size_t begin = last;
    double least = kHookCosine, length = 0;
    for (std::size_t i = last - 1; i > 0; --i) {
        length += (points[i + 1].position - points[i].position).norm();
        if (length > longest) break;
        const auto distance = [&](std::size_t k) {
            return (points[k].position - points[i].position).norm();
        };
        std::size_t before = i, after = i;
        while (before > 0 && distance(before) < kLineReach * pen)
            --before;
        while (after < last && distance(after) < kLineReach * pen)
            ++after;
        const Vector2d along = (points[i].position - points[before].position).stableNormalized();
        const Vector2d hook = (points[after].position - points[i].position).stableNormalized();
        if (along.dot(hook) >= least) continue;
        if (length > kLongestHook * pen && !is_faint(points, i)) continue;
        least = along.dot(hook);
        begin = i;
    }
    return begin;
}

}  // namespace

void cut_hooks(std::vector<DrawnLine>& lines, double pen) {
    const DrawnLines all = all_of(lines, pen);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        DrawnLine& line = lines[i];
        if (!is_inner(line) || line.closed || length_of(line.points) < 2 * kLongestHook * pen)
            continue;
        std::vector<DrawnPoint> points = refine(line.points, kStep * pen);
        for (int end = 0; end < 2; ++end) {
            std::reverse(points.begin(), points.end());
            if (!all.is_near(points.back().position, i, kSamePlace * pen))
                points.resize(begin_of_hook(points, pen) + 1);
        }
        line.points = std::move(points);
    }
}

void point_ends(std::vector<DrawnLine>& lines, const Pens& pens) {
    const double pen = pens[std::size_t(LineClass::Inner)];
    const DrawnLines all = all_of(lines, pen);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        DrawnLine& line = lines[i];
        if (!is_on_curved(line)) continue;
        const bool is_contour = is_curved_contour(line);
        const double least = pens[std::size_t(LineClass::Fine)] /
                             (is_contour ? pens[std::size_t(LineClass::Contour)] : pen);
        const double length = length_of(line.points), third = length / 3;
        const auto is_loose = [&](const DrawnPoint& end) {
            return !line.closed && !all.is_near(end.position, i, kSamePlace * pen);
        };
        const bool begins = is_loose(line.points.front()), ends = is_loose(line.points.back());
        line.points = refine(line.points, pen);
        double at = 0;
        const DrawnPoint* before = &line.points.front();
        for (DrawnPoint& point : line.points) {
            at += (point.position - before->position).norm();
            before = &point;
            const double to_end = std::min(begins ? at : length, ends ? length - at : length);
            const double swelling = is_contour ? 1 : std::min(1., to_end / third);
            point.weight = std::min(1., to_end / std::min(kPointLength * pen, third)) *
                           std::max(swelling * point.weight, least);
        }
    }
}

std::vector<MetEnd> join_ends(std::vector<DrawnLine>& lines, double pen) {
    const DrawnLines all = all_of(lines, kLongestLead * pen);
    std::vector<MetEnd> met;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::vector<DrawnPoint>& points = lines[i].points;
        if (!is_inner(lines[i]) || lines[i].closed || points.size() < 2) continue;
        for (const bool is_last : {false, true}) {
            const DrawnPoint end = is_last ? points.back() : points.front();
            const auto place = all.nearest_on(end.position, i, kLongestLead * pen);
            if (!place) continue;
            const Vector2d way = place->position - end.position;
            if (way.norm() > kSamePlace * pen) {
                const Vector2d outwards = outwards_at(points, is_last, kDirectionReach * pen);
                if (end.weight < kLeastWeight || outwards.dot(way) < kLeadCosine * way.norm())
                    continue;
                DrawnPoint lead = end;
                lead.position = place->position;
                lead.is_exact = lead.is_smoothed = false;
                points.insert(is_last ? points.end() : points.begin(), lead);
            }
            met.push_back({i, is_last, place->line});
        }
    }
    return met;
}

void follow_met(const std::vector<MetEnd>& ends, double pen, std::vector<DrawnLine>& lines) {
    const DrawnLines all = all_of(lines, kLongestLead * pen);
    for (const MetEnd& end : ends) {
        std::vector<DrawnPoint>& points = lines[end.line].points;
        const Vector2d at = (end.is_last ? points.back() : points.front()).position;
        const auto place = all.nearest_on(at, end.line, pen);
        if (place && place->line == end.met)
            shift_end(points, end.is_last, place->position - at, kShiftReach * pen);
    }
}

}  // namespace line_drawing
