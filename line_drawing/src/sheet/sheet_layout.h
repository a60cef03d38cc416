// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_drawing/sheet.h"
#include "strokes/strokes.h"
#include "views/drawn_view.h"

namespace line_drawing {

/// Lengths on a sheet, mm.
constexpr double kSheetMargin = 10, kViewGap = 10, kViewNameHeight = 3, kStripHeight = 16;

struct SheetLayout {
    Eigen::Vector2d size;
    double scale;                       ///< 0: all views are in perspective
    std::vector<Placement> placements;  ///< by view
};

/// Rows and columns around the front view, so that equal heights of the object line up; other
/// directions in rows below. @throws laplacian_lines::Error(InvalidOption) if there is no such
/// paper or the views do not fit
SheetLayout lay_out(const std::vector<DrawnView>& views, const SheetOptions& options);

/// Draws names of views, scale bar, projection symbol, title and notes. Adds remarks to the sheet
/// if texts are too long.
SheetGroup draw_annotations(const std::vector<DrawnView>& views, const SheetLayout& layout,
                            const Eigen::Vector3d& object_size, const SheetOptions& options,
                            Sheet& sheet);

/// Below its view.
std::string name_of(const ViewFrame& frame, bool beside_scale);
/// Width of a text in the widest common font, mm: SVG is shown in the reader's.
double width_in_any_font(const std::string& text, double height);

/// The text, or its beginning and "…".
std::string elided(const std::string& text, double height, double width);

/// A view's strokes, in the sheet's coordinates: its lines cleaned, smoothed, joined and thinned
/// out.
std::vector<DrawnLine> draw_lines(const DrawnView& view, const Placement& placement,
                                  const SheetOptions& options);

/// `number` counts views from 1. Thin lines come first, outlines are over them.
SheetGroup draw_view(const DrawnView& view, std::size_t number, const Placement& placement,
                     const SheetOptions& options);

}  // namespace line_drawing
