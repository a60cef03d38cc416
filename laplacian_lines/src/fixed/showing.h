// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "fixed/line_smoothing.h"
#include "laplacian_lines/line_set.h"
#include "rules/thresholds.h"

namespace laplacian_lines {

/// What decides which lines of a set are shown.
struct ShowingRules {
    float least_length = 0;  ///< D
    int smoothing_passes = 0;
};

/// Appends the lines of the set that are long enough and have a point to be seen.
/// `opacity_of(i)` is the opacity of point i of the set; `may_show(i)` is false if that is 0 for
/// all points of line i.
template <class MayShow, class OpacityOf>
void append_lines(const LineSet& set, const ShowingRules& rules, const MayShow& may_show,
                  const OpacityOf& opacity_of, LineSet& lines) {
    for (std::size_t number = 0; number < set.lines.size(); ++number) {
        Polyline line = set.lines[number];
        if (line.length < rules.least_length || !may_show(number)) continue;
        const std::size_t begin = line.first, end = begin + line.count;
        line.first = std::uint32_t(lines.points.size());
        float most = 0;
        for (std::size_t i = begin; i < end; ++i) {
            LinePoint point = set.points[i];
            point.opacity = point.weight = opacity_of(i);
            most = std::max(most, point.opacity);
            lines.points.push_back(point);
        }
        if (most == 0) {
            lines.points.resize(line.first);
            continue;
        }
        smooth_positions(line, lines.points.data() + line.first, rules.smoothing_passes);
        lines.lines.push_back(line);
    }
}

/// From nothing at the angle to full at (1 + fading) times it.
inline float angle_opacity(float angle, float least_angle, float fading) {
    if (angle < least_angle) return 0;
    const float range = least_angle * fading;
    return range > 0 ? std::min((angle - least_angle) / range, 1.f) : 1.f;
}

}  // namespace laplacian_lines
