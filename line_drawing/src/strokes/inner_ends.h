// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "views/drawn_view.h"

namespace line_drawing {

/// Cuts off ends of inner lines that bend aside: a zero of the Laplacian goes on there around the
/// end of the feature, which an illustrator does not. Ends that meet another line stay. `pen`: of
/// inner lines, mm.
void cutHooks(std::vector<DrawnLine>& lines, double pen);

/// An end of an inner line that meets another line.
struct MetEnd {
    std::size_t line;
    bool is_last;
    std::size_t met;
};

/// Leads ends of inner lines that are drawn in full and head for another line to that line, over
/// three pens at the most: arrises meet each other and outlines. Returns these ends, and those that
/// met a line before.
std::vector<MetEnd> joinEnds(std::vector<DrawnLine>& lines, double pen);

/// Takes ends along that met a line which has moved since, by less than a pen.
void followMet(const std::vector<MetEnd>& ends, double pen, std::vector<DrawnLine>& lines);

}  // namespace line_drawing
