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

/// A piece of a line, on which it is decided at once.
struct LinePiece {
    LinePlace begin, end;
    double length;   ///< in the points' unit
    int place = -1;  ///< which of the places it begins at, -1 if at none
};

/// Pieces of about the given length at most, which begin anew at each of `places`, in the line's
/// order. Those of a closed line begin with its first point.
std::vector<LinePiece> pieces_of(const LineSet& lines, const Polyline& line, double spacing,
                                 const std::vector<LinePlace>& places);

/// The middle of a piece, by its length.
LinePlace middle_of(const LineSet& lines, const Polyline& line, const LinePiece& piece);

/// The parts of a line whose pieces have `label`, in the line's order. Parts of a closed line do
/// not end at its first point. At a change of labels `end_of(piece)` is the exact place.
std::vector<LinePart> parts_of(const Polyline& line, const std::vector<LinePiece>& pieces,
                               const std::vector<std::uint8_t>& labels, std::uint8_t label,
                               const std::function<LinePlace(std::size_t piece)>& begin_of);

/// Adds a part of a line of `from` as a line of its own. `diagonal` is the unit of lengths.
void append_part(const LineSet& from, const Polyline& line, const LinePart& part, double diagonal,
                 LineSet& to);

}  // namespace laplacian_lines
