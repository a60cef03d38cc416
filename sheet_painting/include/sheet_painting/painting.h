// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainter>
#include <QPainterPath>

#include "line_drawing/sheet.h"

namespace sheet_painting {

QPainterPath painterPath(const line_drawing::Path& path);

/// As line_drawing::LetterOutlines, of a font of this machine.
line_drawing::Path outlinesOf(const std::string& text);

/// A sheet in black, by a painter whose unit is a millimetre.
void paint(const line_drawing::Sheet& sheet, QPainter& painter);

constexpr double mm_per_inch = 25.4;

}  // namespace sheet_painting
