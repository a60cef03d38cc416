// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/sight_smoothing.h"

namespace laplacian_lines {

void smooth_between_exact(int passes, SightLine& line) {
    std::vector<SightPoint>& points = line.points;
    const std::size_t last = points.size() - 1;
    if (last < 2) return;
    for (int pass = 0; pass < passes; ++pass) {
        Eigen::Vector3d before = points[last - 1].position;
        const Eigen::Vector3d second = points[1].position;
        for (std::size_t i = 0; i <= last; ++i) {
            const Eigen::Vector3d here = points[i].position;
            const Eigen::Vector3d& after = i < last ? points[i + 1].position : second;
            const bool stays = points[i].is_exact || (!line.closed && (i == 0 || i == last));
            if (!stays) points[i].position = (before + 2 * here + after) / 4;
            before = here;
        }
    }
}

}  // namespace laplacian_lines
