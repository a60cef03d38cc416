// SPDX-License-Identifier: GPL-3.0-or-later
#include "plane_lines.h"

#include <limits>

namespace benchmarks {

NearSegments::NearSegments(const PlaneLines& lines, double reach) : reach_(reach) {
    for (std::size_t l = 0; l < lines.size(); ++l) {
        double along = 0;
        const std::size_t count = lines[l].size();
        for (std::size_t i = 0; i + 1 < count; ++i) {
            const PlanePoint way = lines[l][i + 1] - lines[l][i];
            add({lines[l][i], way, along, std::uint32_t(l), i == 0, i + 2 == count});
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
        auto& cell = cells_[key(cell_of(segment.begin + segment.way * (double(k) / pieces)))];
        if (cell.empty() || cell.back() != number) cell.push_back(number);
    }
}

NearPlace NearSegments::nearest_on(const Segment& segment, const PlanePoint& p) {
    const double length = segment.way.norm();
    if (!(length > 0))
        return {
            (p - segment.begin).norm(), segment.begin, {1, 0}, segment.line, segment.along, true};
    const PlanePoint direction = segment.way / length;
    const double t = std::clamp((p - segment.begin).dot(direction), 0., length);
    const PlanePoint foot = segment.begin + t * direction;
    const bool is_end = (segment.is_first && t == 0) || (segment.is_last && t == length);
    return {(p - foot).norm(), foot, direction, segment.line, segment.along + t, is_end};
}

double NearSegments::distance(const PlanePoint& p) const {
    double least = std::numeric_limits<double>::infinity();
    any_near(p, [&](const NearPlace& place) {
        least = std::min(least, place.distance);
        return false;
    });
    return least;
}

}  // namespace benchmarks
