// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "views/drawn_view.h"

namespace line_drawing {

/// Leaves white between lines: of inner lines in mm on the sheet, the strongest first, what runs
/// beside another one within three pens, or beside an outline, contour or edge with less than half
/// a pen between, goes; where lines cross or meet they stay. Strokes of less than six pens go,
/// those within four pens, and loops of less than 24; then contours of curved surfaces of less than
/// six pens that meet no line. `pens`: widths in mm, by LineClass.
std::vector<DrawnLine> thinOut(std::vector<DrawnLine> lines,
                               const std::array<double, line_class_count>& pens);

}  // namespace line_drawing
