// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "line_drawing/sheet_file.h"

namespace line_drawing {

/// SVG 1.1 whose user unit is a millimetre; groups and layers are Inkscape's layers.
std::string writeSvg(const Sheet& sheet);
/// PDF of one page in the standard fonts, which are not in the file.
/// @throws laplacian_lines::Error(InvalidOption) if these lack a letter and there are no outlines.
std::string writePdf(const Sheet& sheet, const LetterOutlines& outlines = {});
/// DXF R12 in millimetres, y up; polylines, in a layer for each class of lines. Filled areas are
/// drawn by their outlines.
std::string writeDxf(const Sheet& sheet);

}  // namespace line_drawing
