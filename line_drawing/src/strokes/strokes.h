// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "line_drawing/sheet.h"
#include "views/drawn_view.h"

namespace line_drawing {

/// In the sheet's coordinates; none if the line is too short or too thin.
std::optional<SheetPath> drawStroke(const DrawnLine& line, const SheetOptions& options);

}  // namespace line_drawing
