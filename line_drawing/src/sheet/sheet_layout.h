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
    std::vector<Placement> placements;  ///< one for each view
};

/// Rows and columns around the front view, so that equal heights of the object line up; other
/// directions in rows below. @throws laplacian_lines::Error(InvalidOption) if there is no such
/// paper or the views do not fit
SheetLayout lay_out(const std::vector<DrawnView>& views, const SheetOptions& options);

/// For the largest view of a drawing, mm on paper: small ones have pens one or two steps finer.
Pens pens_for(double size, Pens pens);

/// Names of views, scale bar, projection symbol, title. Adds remarks to the sheet if texts are too
/// long.
SheetGroup draw_furniture(const std::vector<DrawnView>& views, const SheetLayout& layout,
                          const Eigen::Vector3d& object_size, const SheetOptions& options,
                          Sheet& sheet);

/// Below its view.
std::string name_of(const ViewFrame& frame, bool beside_scale);
/// Of a text in the widest usual font, mm: SVG has the reader's.
double width_in_any_font(const std::string& text, double height);

/// The text, or its beginning and "…".
std::string elided(const std::string& text, double height, double width);

/// A view's strokes, in the sheet's coordinates: its lines without what a drawing leaves out,
/// eased, joined.
std::vector<DrawnLine> draw_lines(const DrawnView& view, const Placement& placement,
                                  const SheetOptions& options);

/// `number` counts views from 1. Thin lines come first, outlines lie over them.
SheetGroup draw_view(const DrawnView& view, std::size_t number, const Placement& placement,
                     const SheetOptions& options);

}  // namespace line_drawing
