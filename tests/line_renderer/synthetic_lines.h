// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "laplacian_lines/line_set.h"

/// Adds a line of full weight that follows no mesh edges.
inline void add_line(laplacian_lines::LineSet& lines, const std::vector<Eigen::Vector3f>& points,
                     laplacian_lines::LineKind kind = laplacian_lines::LineKind::Laplacian,
                     bool closed = false, float opacity = 1) {
    laplacian_lines::Polyline line;
    line.first = std::uint32_t(lines.points.size());
    line.count = std::uint32_t(points.size());
    line.kind = kind;
    line.closed = closed;
    for (const Eigen::Vector3f& point : points)
        lines.points.push_back({point, 1, 1, opacity});
    lines.lines.push_back(line);
}

/// Makes points from `first` on vertices of a mesh, between which contours follow edges.
inline void put_on_vertices(laplacian_lines::LineSet& lines, std::size_t first, std::size_t count) {
    for (std::size_t i = first; i < first + count; ++i)
        lines.points[i].gradient = 0;
}

inline laplacian_lines::LineSet one_line(const std::vector<Eigen::Vector3f>& points) {
    laplacian_lines::LineSet lines;
    add_line(lines, points);
    return lines;
}
