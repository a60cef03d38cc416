// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_drawing/sheet.h"
#include "views/drawn_view.h"

namespace line_drawing {

/// `number` counts views from 1; `surface_place` is the surface's on the sheet. Thin lines come
/// first, outlines lie over them.
SheetGroup drawView(const DrawnView& view, std::size_t number, const Placement& placement,
                    const Eigen::AlignedBox2d& surface_place, const SheetOptions& options);

}  // namespace line_drawing
