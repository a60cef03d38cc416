// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_drawing/sheet.h"
#include "views/drawn_view.h"

namespace line_drawing {

/// A view as it is drawn on the sheet; `number` is its place among the views, from 1 on,
/// `surface_place` that of its surface on the sheet. Thin lines first: outlines lie over them.
SheetGroup drawView(const DrawnView& view, std::size_t number, const Placement& placement,
                    const Eigen::AlignedBox2d& surface_place, const SheetOptions& options);

}  // namespace line_drawing
