// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pixels/canvas.h"

namespace line_drawing {

/// What a pen covers along a line, as polygons to be filled by FillRule::NonZero; all in pixels.
/// Its tip is round, and of dashes, which have gaps of half of their length, cut off. A line of one
/// point has nothing; one without length has a dot, or of dashes nothing.
void appendStroke(const Polygon& line, double width, double dash, std::vector<Polygon>& polygons);

}  // namespace line_drawing
