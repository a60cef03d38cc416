// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "line_drawing/sheet.h"
#include "views/drawn_view.h"

namespace line_drawing {

/// A line, in the sheet's coordinates, as it is drawn; none if it is too short or too thin.
std::optional<SheetPath> drawStroke(const DrawnLine& line, const SheetOptions& options);

}  // namespace line_drawing
