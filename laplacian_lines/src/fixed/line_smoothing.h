// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>

#include "laplacian_lines/line_set.h"

namespace laplacian_lines {

/// What lies beyond an open end.
enum class LineEnd {
    Repeated,   ///< the end again: values change evenly up to it
    Reflected,  ///< what is before it, mirrored in the end, which stays where it is
};

/// Passes of binomial smoothing (1-2-1) over `count` values, at(i) each, of which those for which
/// stays(i) stay. The first value of closed lines and its copy at the end stay equal.
template <LineEnd end = LineEnd::Reflected, class ValueAt, class Stays>
void smooth_binomially(std::size_t count, bool closed, int passes, ValueAt at, Stays stays) {
    using Value = std::decay_t<decltype(at(0))>;
    const auto beyond = [](const Value& last, const Value& inner) {
        return end == LineEnd::Repeated ? last : Value(2 * last - inner);
    };
    const std::size_t last = count - 1;
    for (int pass = 0; pass < passes; ++pass) {
        const Value second = at(1);
        Value before = closed ? at(last - 1) : beyond(at(0), second);
        for (std::size_t i = 0; i <= last; ++i) {
            const Value here = at(i);
            const Value after = i < last ? at(i + 1) : closed ? second : beyond(here, before);
            if (!stays(i)) at(i) = (before + 2 * here + after) / 4;
            before = here;
        }
    }
}

/// The same of a line's points, open ends of which stay where they are.
inline void smooth_positions(const Polyline& line, LinePoint* points, int passes) {
    smooth_binomially(
        line.count, line.closed, passes,
        [&](std::size_t i) -> Eigen::Vector3f& { return points[i].position; },
        [](std::size_t) { return false; });
}

}  // namespace laplacian_lines
