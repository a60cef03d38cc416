// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "strokes/strokes.h"

namespace line_drawing {

/// Lengths on a sheet, mm.
constexpr double sheet_margin = 10, view_gap = 10, view_name_height = 3, strip_height = 16;

struct SheetLayout {
    Eigen::Vector2d size;
    double scale;                             ///< 0: all views are in perspective
    std::vector<Placement> placements;        ///< one for each view
    std::vector<Eigen::AlignedBox2d> places;  ///< of the views' surfaces, mm
};

/// Whether there is no scale at all.
bool areInPerspective(const std::vector<DrawnView>& views);

/// Places views in rows and columns around the front view, so that what is at one height of the
/// object is at one height of the sheet; views of other directions stand in rows below.
/// @throws laplacian_lines::Error(InvalidOption) if there is no such paper or the views do not fit.
SheetLayout layOut(const std::vector<DrawnView>& views, const SheetOptions& options);

}  // namespace line_drawing
