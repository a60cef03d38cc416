// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/line_set.h"

namespace laplacian_lines {

/// What stands in for the point beyond an open end.
enum class LineEnd {
    Repeated,   ///< the last value again: values change evenly up to the end
    Reflected,  ///< the point before it, mirrored in the end: ends stay where they are
};

/// One pass of binomial smoothing (1-2-1) of a member of the line's points. `points` are the
/// line's; a closed line's first point and its copy stay equal.
template <class Value>
void smooth_line(const Polyline& line, LinePoint* points, Value LinePoint::*value, LineEnd end) {
    const std::uint32_t last = line.count - 1;
    const auto beyond = [&](const Value& here, const Value& inner) -> Value {
        return end == LineEnd::Repeated ? here : Value(2 * here - inner);
    };
    const Value second = points[1].*value;
    Value before = line.closed ? points[last - 1].*value : beyond(points[0].*value, second);
    for (std::uint32_t i = 0; i <= last; ++i) {
        const Value here = points[i].*value;
        const Value after = i < last      ? points[i + 1].*value
                            : line.closed ? second
                                          : beyond(here, before);
        points[i].*value = (before + 2 * here + after) / 4;
        before = here;
    }
}

}  // namespace laplacian_lines
