// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "views/drawn_view.h"

namespace line_drawing {

/// A place in the table of views, whose front view is in row 0 and column 0.
struct Cell {
    int row, column;  ///< downwards, to the right
};

/// Where views have a choice.
struct CellChoice {
    bool others_beside = false;  ///< views of no side end the front view's row, else in rows below
    int sections_in_a_row = 0;   ///< below all views; 0: they are beside or below the front view
};

/// The cells of views, each its own. In `views`, sections have to come last. The sides of an
/// object are around the front view, in the options' angle of projection, views of no side as
/// chosen. Sections, and views of a side that another one shows already, are at the end of the
/// front view's row, or of its column if they look from above or below, unless sections are in
/// rows.
std::vector<Cell> cells_of(const std::vector<DrawnView>& views, const SheetOptions& options,
                           const CellChoice& choice);

}  // namespace line_drawing
