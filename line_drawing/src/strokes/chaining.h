// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "views/drawn_view.h"

namespace line_drawing {

/// Makes one stroke of inner lines that go on as each other: where they meet, and over gaps of up
/// to eight pens, half as long as either of them, that no other line crosses; and of contours
/// within the surface that go on at the same place. If it `mixes_kinds`, also of inner lines and
/// contours whose ends meet; their widths pass into each other. `pens`: widths in mm, by LineClass.
std::vector<DrawnLine> chain(std::vector<DrawnLine> lines,
                             const std::array<double, line_class_count>& pens, bool mixes_kinds);

}  // namespace line_drawing
