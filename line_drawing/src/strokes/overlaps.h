// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "views/drawn_view.h"

namespace line_drawing {

/// Joins ends that have lost the line they met: by `left_out` short lines that lead on to another,
/// else by a straight piece; an edge that has passed another ends there. Other ends stay, since
/// lines may meet them. `reach`: of what doubles a line.
void joinLooseEnds(std::vector<DrawnLine>& lines, const std::vector<DrawnLine>& left_out,
                   double reach);

/// Removes parts of lines that only double others, in the sheet's coordinates: of lower classes
/// along higher ones (sections first), in a class along longer ones; also jogs, and short lines
/// that are beside others nearly all along, unless they join an end to another line. What is left
/// meets the lines beside its ends.
std::vector<DrawnLine> withoutDoubles(std::vector<DrawnLine> lines, double reach);

}  // namespace line_drawing
