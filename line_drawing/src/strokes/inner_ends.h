// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "views/drawn_view.h"

namespace line_drawing {

/// Cuts off bent ends of inner lines, where a zero of the Laplacian runs around the end of a
/// feature; an illustrator would not draw that. Ends that meet another line stay. `pen`: of inner
/// lines, mm.
void cutHooks(std::vector<DrawnLine>& lines, double pen);

struct MetEnd {
    std::size_t line;
    bool is_last;
    std::size_t met;
};

/// Extends ends of inner lines that are drawn in full and head for another line to that line, over
/// at most three pens: arrises meet each other and outlines. Returns these ends, and those that met
/// a line before.
std::vector<MetEnd> joinEnds(std::vector<DrawnLine>& lines, double pen);

/// Moves ends with the line they met, if that has moved by less than a pen.
void followMet(const std::vector<MetEnd>& ends, double pen, std::vector<DrawnLine>& lines);

}  // namespace line_drawing
