// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "views/drawn_view.h"

namespace line_drawing {

/// Lines, on the sheet, without what would be specks of it: contours of curved surfaces before a
/// jump in depth that is less than a pen, lines shorter than the shortest one that end in nothing,
/// and such ends of lines behind the last line that they meet. The kernel is in mm of the sheet.
/// Outlines stay as they are.
std::vector<DrawnLine> withoutSlightLines(std::vector<DrawnLine> lines,
                                          const SheetOptions& options);

}  // namespace line_drawing
