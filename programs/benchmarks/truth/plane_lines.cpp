// SPDX-License-Identifier: GPL-3.0-or-later
#include "plane_lines.h"

#include <algorithm>

namespace benchmarks {

double length_of(const PlaneLine& line) {
    double length = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        length += (line[i + 1] - line[i]).norm();
    return length;
}

NearSegments::NearSegments(const PlaneLines& lines, double reach) : reach_(reach) {
    for (std::size_t l = 0; l < lines.size(); ++l) {
        double along = 0;
        for (std::size_t i = 0; i + 1 < lines[l].size(); ++i) {
            const PlanePoint way = lines[l][i + 1] - lines[l][i];
            add({lines[l][i], way, along, l});
            along += way.norm();
        }
    }
}

/// Into the cells of its ends, in pieces shorter than a cell: cells around a point then have all
/// within reach.
void NearSegments::add(const Segment& segment) {
    const auto number = std::uint32_t(segments_.size());
    segments_.push_back(segment);
    const int pieces = 1 + int(segment.way.norm() / (0.5 * reach_));
    for (int k = 0; k <= pieces; ++k) {
        auto& cell = cells_[key(cell_of(segment.at(double(k) / pieces)))];
        if (cell.empty() || cell.back() != number) cell.push_back(number);
    }
}

double NearSegments::nearest_on(const Segment& segment, const PlanePoint& p) {
    const double square = segment.way.squaredNorm();
    return square > 0 ? std::clamp((p - segment.begin).dot(segment.way) / square, 0., 1.) : 0;
}

}  // namespace benchmarks
