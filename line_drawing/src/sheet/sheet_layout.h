// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_drawing/sheet.h"
#include "strokes/strokes.h"
#include "views/drawn_view.h"

namespace line_drawing {

/// Lengths on a sheet, mm.
constexpr double sheet_margin = 10, view_gap = 10, view_name_height = 3, strip_height = 16;

struct SheetLayout {
    Eigen::Vector2d size;
    double scale;                       ///< 0: all views are in perspective
    std::vector<Placement> placements;  ///< one for each view
};

/// Rows and columns around the front view, so that equal heights of the object line up; other
/// directions in rows below. @throws laplacian_lines::Error(InvalidOption) if there is no such
/// paper or the views do not fit
SheetLayout layOut(const std::vector<DrawnView>& views, const SheetOptions& options);

/// For the largest view of a drawing, mm on paper: small ones have pens one or two steps finer.
Pens pensFor(double size, Pens pens);

/// Names of views, scale bar, projection symbol, title. Adds remarks to the sheet if texts are too
/// long.
SheetGroup drawFurniture(const std::vector<DrawnView>& views, const SheetLayout& layout,
                         const Eigen::Vector3d& object_size, const SheetOptions& options,
                         Sheet& sheet);

/// Below its view.
std::string nameOf(const ViewFrame& frame, bool beside_scale);
/// Of a text in the widest usual font, mm: SVG has the reader's.
double widthInAnyFont(const std::string& text, double height);

/// The text, or its beginning and "…".
std::string elided(const std::string& text, double height, double width);

/// A view's strokes, in the sheet's coordinates: its lines without what a drawing leaves out,
/// eased, joined.
std::vector<DrawnLine> drawLines(const DrawnView& view, const Placement& placement,
                                 const SheetOptions& options);

/// `number` counts views from 1. Thin lines come first, outlines lie over them.
SheetGroup drawView(const DrawnView& view, std::size_t number, const Placement& placement,
                    const SheetOptions& options);

}  // namespace line_drawing
