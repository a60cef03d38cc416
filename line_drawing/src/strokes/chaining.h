// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "views/drawn_view.h"

namespace line_drawing {

/// Joins inner lines that continue each other into one stroke, where they meet or across gaps of up
/// to eight pens, half as long as either line, that no other line crosses; and contours within the
/// surface that meet. With `mixes_kinds`, also inner lines and contours whose ends meet, blending
/// their widths. `pens`: widths in mm, by LineClass.
std::vector<DrawnLine> chain(std::vector<DrawnLine> lines,
                             const std::array<double, line_class_count>& pens, bool mixes_kinds);

}  // namespace line_drawing
