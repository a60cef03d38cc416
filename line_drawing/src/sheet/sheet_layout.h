// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_drawing/sheet.h"
#include "views/drawn_view.h"

namespace line_drawing {

/// Lengths on a sheet, mm.
constexpr double kSheetMargin = 10, kViewGap = 10, kStripHeight = 16;

struct SheetLayout {
    Eigen::Vector2d size;
    double scale;                       ///< 0: all views are in perspective
    std::vector<Placement> placements;  ///< by view
};

/// Rows and columns around the front view, so that equal heights of the object line up; other
/// directions below or at the end of its row. @throws laplacian_lines::Error(InvalidOption) if
/// there is no such paper or the views do not fit
SheetLayout lay_out(const std::vector<DrawnView>& views, const SheetOptions& options);

}  // namespace line_drawing
