// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_drawing/sheet.h"
#include "views/drawn_view.h"

namespace line_drawing {

/// A view's strokes, in the sheet's coordinates: its lines cleaned, smoothed, joined and thinned
/// out.
std::vector<DrawnLine> draw_lines(const DrawnView& view, const Placement& placement,
                                  const SheetOptions& options);

/// `number` counts views from 1. Areas come first, outlines are over other lines.
SheetGroup draw_view(const DrawnView& view, std::size_t number, const Placement& placement,
                     const SheetOptions& options);

}  // namespace line_drawing
