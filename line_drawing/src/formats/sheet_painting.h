// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPainter>

#include "line_drawing/sheet.h"

namespace line_drawing {

/// 0 black, 1 white
QColor grey(double tone);

constexpr double mm_per_inch = 25.4;

/// A sheet in black, by a painter whose unit is a millimetre. Text becomes outlines, since a font
/// of this machine need not be on another.
void paint(const Sheet& sheet, QPainter& painter);

}  // namespace line_drawing
