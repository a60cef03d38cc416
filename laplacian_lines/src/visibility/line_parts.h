// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "laplacian_lines/line_set.h"

namespace laplacian_lines {

/// A place on a line: between its points `segment` and `segment` + 1.
struct LinePlace {
    std::uint32_t segment = 0;
    double t = 0;  ///< 0..1
};

/// A part of a line from one place to another; of a closed line it may run over the first point.
struct LinePart {
    LinePlace begin, end;
    bool whole = false;  ///< the whole line, closed if that is
};

LinePoint point_at(const LineSet& lines, const Polyline& line, const LinePlace& place);

struct PartRules {
    double spacing;   ///< largest distance of places that are looked at, in the points' unit
    double shortest;  ///< gaps and parts below this length do not count, in the points' unit
};

/// The parts of a line on which `holds` does, in the line's order. Their ends are found by
/// bisection. Parts of a closed line do not end at its first point.
std::vector<LinePart> parts_where(const LineSet& lines, const Polyline& line,
                                  const PartRules& rules,
                                  const std::function<bool(const LinePlace&)>& holds);

/// Adds a part of a line of `from` as a line of its own. `diagonal` is the unit of lengths.
void append_part(const LineSet& from, const Polyline& line, const LinePart& part, double diagonal,
                 LineSet& to);

}  // namespace laplacian_lines
