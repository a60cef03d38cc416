// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "line_drawing/sheet.h"

namespace line_drawing {

/// SVG 1.1 whose user unit is a millimetre; groups and layers are Inkscape's layers.
std::string writeSvg(const Sheet& sheet);
/// DXF R12 in millimetres, y up; polylines, in a layer for each class of lines. Filled areas are
/// drawn by their outlines.
std::string writeDxf(const Sheet& sheet);

}  // namespace line_drawing
