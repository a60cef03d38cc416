// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "line_drawing/sheet_file.h"

namespace line_drawing {

/// By zlib (RFC 1950).
std::string deflated(const std::string& bytes);

// Of SheetFormat; `dpi` is for pictures.

/// SVG 1.1 with millimetres as user units; groups and layers are Inkscape's layers.
std::string write_svg(const Sheet& sheet, double dpi);
/// One page in PDF's standard fonts, which are not embedded; texts with other letters become
/// outlines.
std::string write_pdf(const Sheet& sheet, double dpi);
/// 256 grays, black on white. @throws laplacian_lines::Error(InvalidOption) if it would be too
/// large
std::string write_png(const Sheet& sheet, double dpi);
/// R12, millimetres, y up: polylines, a layer per view and class of lines, areas by their outlines.
std::string write_dxf(const Sheet& sheet, double dpi);

}  // namespace line_drawing
