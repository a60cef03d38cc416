// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "laplacian_lines/line_set.h"

inline void add_line(laplacian_lines::LineSet& lines,
                     const std::vector<laplacian_lines::LinePoint>& points,
                     laplacian_lines::LineKind kind = laplacian_lines::LineKind::Laplacian,
                     bool closed = false) {
    laplacian_lines::Polyline line;
    line.first = std::uint32_t(lines.points.size());
    line.count = std::uint32_t(points.size());
    line.kind = kind;
    line.closed = closed;
    lines.points.insert(lines.points.end(), points.begin(), points.end());
    lines.lines.push_back(line);
}

/// Of full weight; of contours, off mesh edges.
inline void add_line(laplacian_lines::LineSet& lines, const std::vector<Eigen::Vector3f>& places,
                     laplacian_lines::LineKind kind = laplacian_lines::LineKind::Laplacian,
                     bool closed = false, float opacity = 1) {
    std::vector<laplacian_lines::LinePoint> points;
    for (const Eigen::Vector3f& place : places)
        points.push_back({place, 1, 1, opacity});
    add_line(lines, points, kind, closed);
}

inline laplacian_lines::LineSet one_line(const std::vector<Eigen::Vector3f>& points) {
    laplacian_lines::LineSet lines;
    add_line(lines, points);
    return lines;
}
