// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "views/drawn_view.h"

namespace line_drawing {

/// A place in the table of views, whose front view is in row 0 and column 0.
struct Cell {
    int row, column;  ///< downwards, to the right
};

/// The cells of views, each its own. The sides of an object are around the front view, in the
/// options' angle of projection, views of no side (by azimuth and elevation) in rows below.
/// Sections, and views of a side that another one shows already, are at the end of the front view's
/// row, or of its column if they look from above or below. If `sections_in_a_row` is not 0,
/// sections are in rows of so many at the bottom instead.
std::vector<Cell> cells_of(const std::vector<DrawnView>& views, const SheetOptions& options,
                           int sections_in_a_row);

}  // namespace line_drawing
