// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/near_lines.h"

#include <algorithm>

#include "mesh/box_tree.h"
#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3f;

constexpr float kAlong = 0.5f;     // least squared cosine
constexpr float kRoundUp = 1.01f;  // of boxes, which only preselect

/// Whether a piece passes within the distance of p, about in this direction.
bool is_along(const Vector3f& begin, const Vector3f& end, float distance, const Vector3f& p,
              const Vector3f& direction) {
    const Vector3f span = end - begin;
    const float length = squared_length_of(span);
    const float t = length > 0 ? std::clamp(dot(p - begin, span) / length, 0.f, 1.f) : 0.f;
    if (squared_length_of(begin + t * span - p) > distance * distance) return false;
    const float product = dot(span, direction);
    return product * product >= kAlong * length * squared_length_of(direction);
}

}  // namespace

std::vector<std::uint8_t> points_along(const LineSet& lines, const LineSet& others,
                                       float distance) {
    std::vector<std::uint32_t> begins;  // points from which pieces go to the next
    Eigen::AlignedBox3f bounds;
    for (const Polyline& line : others.lines)
        for (std::uint32_t i = line.first; i + 1 < line.first + line.count; ++i)
            begins.push_back(i);
    for (const LinePoint& point : others.points)
        bounds.extend(point.position);
    const auto at = [&](std::uint32_t i) -> const Vector3f& { return others.points[i].position; };
    const auto tree = BoxTree<3>::along_curve(std::move(begins), bounds, [&](std::uint32_t begin) {
        const Vector3f room = Vector3f::Constant(kRoundUp * distance);
        const Vector3f &a = at(begin), &b = at(begin + 1);
        return Eigen::AlignedBox3f(a.cwiseMin(b) - room, a.cwiseMax(b) + room);
    });
    std::vector<std::uint8_t> along(lines.points.size(), 0);
    in_parallel(lines.lines.size(), [&](std::size_t number) {
        const Polyline& line = lines.lines[number];
        const LinePoint* points = lines.points.data() + line.first;
        for (std::uint32_t i = 0; i < line.count; ++i) {
            const Vector3f& p = points[i].position;
            const Vector3f direction = points[std::min(i + 1, line.count - 1)].position -
                                       points[i > 0 ? i - 1 : 0].position;
            along[line.first + i] = !tree.visit(Eigen::AlignedBox3f(p), [&](std::uint32_t begin) {
                return !is_along(at(begin), at(begin + 1), distance, p, direction);
            });
        }
    });
    return along;
}

}  // namespace laplacian_lines
