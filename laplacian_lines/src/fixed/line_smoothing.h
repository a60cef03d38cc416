// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>

#include "laplacian_lines/line_set.h"

namespace laplacian_lines {

/// Passes of binomial smoothing (1-2-1) over `count` positions at(i); those for which stays(i) is
/// true stay. Open ends are extended by the position before, mirrored in the end. The first
/// position of closed lines and its copy at the end stay equal.
template <class PositionAt, class Stays>
void smooth_binomially(std::size_t count, bool closed, int passes, PositionAt at, Stays stays) {
    using Position = std::decay_t<decltype(at(0))>;
    const std::size_t last = count - 1;
    for (int pass = 0; pass < passes; ++pass) {
        const Position second = at(1);
        Position before = closed ? at(last - 1) : Position(2 * at(0) - second);
        for (std::size_t i = 0; i <= last; ++i) {
            const Position here = at(i);
            const Position after = i < last ? at(i + 1)
                                   : closed ? second
                                            : Position(2 * here - before);
            if (!stays(i)) at(i) = (before + 2 * here + after) / 4;
            before = here;
        }
    }
}

/// Smooths a line's points; open ends stay.
inline void smooth_positions(const Polyline& line, LinePoint* points, int passes) {
    smooth_binomially(
        line.count, line.closed, passes,
        [&](std::size_t i) -> Eigen::Vector3f& { return points[i].position; },
        [](std::size_t) { return false; });
}

}  // namespace laplacian_lines
