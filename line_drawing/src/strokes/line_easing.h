// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "views/drawn_view.h"

namespace line_drawing {

/// Takes the triangles' edges out of contours of curved surfaces: between points that are exact,
/// lines bend as little as they can, but stay within `reach` of where they were, on the sheet.
/// Lines that end at them follow. Afterwards all points of contours are exact.
void easeLines(std::vector<DrawnLine>& lines, double reach);

/// The same for inner lines as they are drawn, with what goes on as them, which stays.
void easeInnerLines(std::vector<DrawnLine>& lines, double reach);

}  // namespace line_drawing
