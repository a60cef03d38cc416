// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "views/drawn_view.h"

namespace line_drawing {

/// Joins ends of lines that are in nothing since what they met was left out: by short lines that
/// were `left_out` and lead on to another line, else by a straight piece to what is beside them; an
/// edge that has gone past that ends there. No other end is moved, as others may meet the line
/// there. `reach`: of what doubles a line.
void joinLooseEnds(std::vector<DrawnLine>& lines, const std::vector<DrawnLine>& left_out,
                   double reach);

/// Lines, in the sheet's coordinates, without the parts that only double others: of lower classes
/// those along higher ones (sections first), among one class along longer ones; without short lines
/// that are beside others nearly all along, unless they join an end to another line, and jogs. What
/// is left meets the lines that it ends beside.
std::vector<DrawnLine> withoutDoubles(std::vector<DrawnLine> lines, double reach);

}  // namespace line_drawing
