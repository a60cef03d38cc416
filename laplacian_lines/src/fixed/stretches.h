// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "laplacian_lines/line_set.h"
#include "system/three_floats.h"

namespace laplacian_lines {

/// Successive points of a line; of a closed one they may run over its end.
struct Stretch {
    std::uint32_t first, count;
    std::uint32_t period;  ///< points of the line, without the copy of a closed one's first
    bool is_closed;        ///< all of a closed line

    /// The place of point i in the line.
    std::uint32_t point(std::uint32_t i) const { return (first + i) % period; }
};

/// Calls use(stretch) for the longest stretches of which all points have at least this gradient.
template <class Use>
void for_each_stretch(const Polyline& line, const LinePoint* points, float least, Use use) {
    const std::uint32_t period = line.closed ? line.count - 1 : line.count;
    const auto is_in = [&](std::uint32_t i) { return points[i % period].gradient >= least; };
    std::uint32_t begin = 0;
    if (line.closed) {
        while (begin < period && is_in(begin))
            ++begin;
        if (begin == period) return use(Stretch{0, line.count, period, true});
    }
    for (std::uint32_t i = begin; i < begin + period;) {
        const std::uint32_t first = i;
        while (i < begin + period && is_in(i))
            ++i;
        if (i > first)
            use(Stretch{first, i - first, period, false});
        else
            ++i;
    }
}

/// Length in which sharper pieces count more: what noise makes of a smooth
/// surface is short and dull, the spine of a dragon is short and sharp.
struct SharpLength {
    static constexpr float kPlainAngle = 45;  ///< degrees; up to which a piece counts once
    static constexpr float kMostWeight = 3;

    static float weight(float angle) {
        const float ratio = angle / kPlainAngle;
        return std::clamp(ratio * ratio, 1.f, kMostWeight);
    }
};

/// In D.
struct StretchLengths {
    float all = 0;
    float strong = 0;  ///< of the part of it that has the angle, the longest by SharpLength
};

inline StretchLengths measure(const Stretch& stretch, const LinePoint* points, float angle,
                              float diagonal) {
    StretchLengths lengths;
    float strong = 0;
    for (std::uint32_t i = 1; i < stretch.count; ++i) {
        const LinePoint &a = points[stretch.point(i - 1)], &b = points[stretch.point(i)];
        const float length = length_of(b.position - a.position) / diagonal;
        lengths.all += length;
        const float sharp = std::min(a.gradient, b.gradient);
        strong = sharp >= angle ? strong + SharpLength::weight(sharp) * length : 0;
        lengths.strong = std::max(lengths.strong, strong);
    }
    return lengths;
}

}  // namespace laplacian_lines
