// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>

#include "laplacian_lines/line_set.h"

namespace laplacian_lines {

/// What lies beyond an open end.
enum class LineEnd {
    Repeated,   ///< the end again: values change evenly up to it
    Reflected,  ///< what is before it, mirrored in the end, which stays but for rounding
};

/// Passes of binomial smoothing (1-2-1) over `count` values, at least 2, get(i) each;
/// set(i, value) replaces one. The first value of closed lines and its copy at the end stay equal.
template <LineEnd end = LineEnd::Reflected, class Get, class Set>
void smooth_binomially(std::size_t count, bool closed, int passes, Get get, Set set) {
    using Value = std::decay_t<decltype(get(0))>;
    const auto beyond = [](const Value& last, const Value& inner) {
        return end == LineEnd::Repeated ? last : Value(2 * last - inner);
    };
    const std::size_t last = count - 1;
    for (int pass = 0; pass < passes; ++pass) {
        const Value second = get(1);
        Value here = get(0), before = closed ? get(last - 1) : beyond(here, second);
        for (std::size_t i = 0; i < last; ++i) {
            const Value after = get(i + 1);
            set(i, Value((before + 2 * here + after) / 4));
            before = here;
            here = after;
        }
        set(last, Value((before + 2 * here + (closed ? second : beyond(here, before))) / 4));
    }
}

/// Four successive numbers of a point, from number `first` on, to be smoothed at once.
using FourOfPoint = Eigen::Array4f;
inline FourOfPoint four_of(const LinePoint& point, int first) {
    return Eigen::Map<const FourOfPoint>(reinterpret_cast<const float*>(&point) + first);
}

/// Smooths a line's points; open ends stay.
inline void smooth_positions(const Polyline& line, LinePoint* points, int passes) {
    smooth_binomially(
        line.count, line.closed, passes, [&](std::size_t i) { return four_of(points[i], 0); },
        [&](std::size_t i, const FourOfPoint& p) { points[i].position = p.head<3>(); });
}

}  // namespace laplacian_lines
