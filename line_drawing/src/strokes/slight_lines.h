// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "views/drawn_view.h"

namespace line_drawing {

/// Lines, on the sheet, without what would be specks of it: contours of curved surfaces before a
/// jump in depth that is less than a pen, lines shorter than the shortest one that end in nothing,
/// and such ends of lines behind the last line that they meet. Outlines stay as they are.
std::vector<DrawnLine> withoutSlightLines(std::vector<DrawnLine> lines,
                                          const SheetOptions& options);

/// Inner lines as far as they are a quarter of their full width at least, with what is fainter
/// between two such places for no more than 28 pens: where a line that is hardly there ends does
/// not hang on what it was joined to. `pen`: of inner lines, mm.
std::vector<DrawnLine> withoutFaintParts(std::vector<DrawnLine> lines, double pen);

}  // namespace line_drawing
