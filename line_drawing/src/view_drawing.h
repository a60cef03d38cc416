// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drawn_view.h"
#include "line_drawing/sheet.h"

namespace line_drawing {

/// A view as it is drawn on the sheet; `number` is its place among the views, from 1 on. Thin lines
/// first: outlines lie over them.
SheetGroup drawView(const DrawnView& view, std::size_t number, const Placement& placement,
                    const SheetOptions& options);

}  // namespace line_drawing
