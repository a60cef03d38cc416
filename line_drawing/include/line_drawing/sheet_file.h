// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "line_drawing/sheet.h"
#include "line_drawing/sheet_options.h"

namespace line_drawing {

enum class SheetFormat { Svg, Pdf, Dxf, Png };

/// By the extension. @throws laplacian_lines::Error(InvalidOption) if it is unknown
SheetFormat formatOf(const std::string& file);

/// The bytes of a file at true scale, PNG at `dpi` dots per inch; a function of the sheet alone.
/// @throws laplacian_lines::Error(InvalidOption) if the picture would be too large, with what to do
/// instead
std::string writeSheet(const Sheet& sheet, SheetFormat format, double dpi = 300);

/// Whether the format has the letters of title and source, asked before the work begins.
/// @returns a remark if letters of the source become boxes
/// @throws laplacian_lines::Error(InvalidOption) if the title's do, with what to do instead
std::vector<std::string> checkTexts(const SheetOptions& options, SheetFormat format);

/// The strokes that a format can have: DXF readers draw even widths.
StrokeStyle strokesIn(const std::string& file, StrokeStyle wanted);

}  // namespace line_drawing
