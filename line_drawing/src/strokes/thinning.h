// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "views/drawn_view.h"

namespace line_drawing {

/// Leaves white between lines, mm on the sheet: strongest first, an inner line goes where it runs
/// within three pens of another one, or within half a pen of an outline, contour or edge, but not
/// where lines cross or meet. So do strokes shorter than six pens, those within four pens of each
/// other, loops below 24, then contours of curved surfaces below six pens that meet no line.
/// `pens`: widths in mm, by LineClass.
std::vector<DrawnLine> thinOut(std::vector<DrawnLine> lines,
                               const std::array<double, line_class_count>& pens);

}  // namespace line_drawing
