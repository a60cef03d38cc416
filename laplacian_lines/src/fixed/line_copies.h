// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/line_set.h"

namespace laplacian_lines {

/// The points of a line, without the copy of a closed one's first.
inline std::uint32_t point_count(const Polyline& line) {
    return line.closed ? line.count - 1 : line.count;
}

/// Appends `count` points of a line of `from`, starting at point `begin`. On a closed line they may
/// wrap around, and are closed if they are one more than it has. The length stays that of the line.
inline Polyline& append_points(const LineSet& from, const Polyline& line, std::size_t begin,
                               std::size_t count, LineSet& to) {
    Polyline part = line;
    part.first = std::uint32_t(to.points.size());
    part.count = std::uint32_t(count);
    part.closed = count > point_count(line);
    for (std::size_t i = begin; i < begin + count; ++i)
        to.points.push_back(from.points[line.first + i % point_count(line)]);
    to.lines.push_back(part);
    return to.lines.back();
}

inline Polyline& append_whole(const LineSet& from, const Polyline& line, LineSet& to) {
    return append_points(from, line, 0, line.count, to);
}

}  // namespace laplacian_lines
