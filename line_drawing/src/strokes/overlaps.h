// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "views/drawn_view.h"

namespace line_drawing {

/// Lines, in the sheet's coordinates, without the parts that only double others: of lower classes
/// those along higher ones (sections first), among one class along longer ones; without short lines
/// that are beside others nearly all along, unless they join an end to another line, and jogs. What
/// is left meets the lines that it ends beside.
std::vector<DrawnLine> withoutDoubles(std::vector<DrawnLine> lines, double reach);

}  // namespace line_drawing
