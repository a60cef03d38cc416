// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/line_set.h"

namespace laplacian_lines {

/// Passes of binomial smoothing (1-2-1) over the positions of a line's points. Open ends stay where
/// they are: what lies beyond is the point before, mirrored in the end. A closed line's first point
/// and its copy stay equal.
inline void smooth_positions(const Polyline& line, LinePoint* points, int passes) {
    const std::uint32_t last = line.count - 1;
    for (int pass = 0; pass < passes; ++pass) {
        const Eigen::Vector3f second = points[1].position;
        Eigen::Vector3f before = line.closed ? points[last - 1].position
                                             : Eigen::Vector3f(2 * points[0].position - second);
        for (std::uint32_t i = 0; i <= last; ++i) {
            const Eigen::Vector3f here = points[i].position;
            const Eigen::Vector3f after = i < last      ? points[i + 1].position
                                          : line.closed ? second
                                                        : Eigen::Vector3f(2 * here - before);
            points[i].position = (before + 2 * here + after) / 4;
            before = here;
        }
    }
}

}  // namespace laplacian_lines
