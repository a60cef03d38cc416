// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "views/drawn_view.h"

namespace line_drawing {

/// Removes specks, on the sheet: contours of curved surfaces before a jump in depth of less than a
/// pen, lines and ends of lines shorter than the shortest one that end in nothing. Outlines stay.
std::vector<DrawnLine> withoutSlightLines(std::vector<DrawnLine> lines,
                                          const SheetOptions& options);

}  // namespace line_drawing
