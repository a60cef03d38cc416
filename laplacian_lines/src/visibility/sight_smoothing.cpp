// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/sight_smoothing.h"

#include "fixed/line_smoothing.h"

namespace laplacian_lines {

void smooth_between_exact(int passes, SightLine& line) {
    std::vector<SightPoint>& points = line.points;
    const std::size_t last = points.size() - 1;
    if (last < 2) return;
    smooth_binomially(
        points.size(), line.closed, passes,
        [&](std::size_t i) -> Eigen::Vector3d& { return points[i].position; },
        [&](std::size_t i) {
            return points[i].is_exact || (!line.closed && (i == 0 || i == last));
        });
}

}  // namespace laplacian_lines
