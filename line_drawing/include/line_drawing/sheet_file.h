// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "line_drawing/sheet.h"
#include "line_drawing/sheet_options.h"

namespace line_drawing {

enum class SheetFormat { Svg, Pdf, Dxf, Png };

/// By the ending of the file's name.
/// @throws laplacian_lines::Error(InvalidOption) if it is another one.
SheetFormat formatOf(const std::string& file);

/// A sheet as a file, so that a millimetre of the sheet is one of the file; PNG has `dpi` dots per
/// inch. The same sheet gives the same bytes.
/// @throws laplacian_lines::Error(InvalidOption): too large a picture, with what to do instead.
std::string writeSheet(const Sheet& sheet, SheetFormat format, double dpi = 300);

/// Before much work is done: whether the format has the letters of title and source, whose names
/// nobody chose for a drawing.
/// @returns a remark, if there are boxes instead of letters of the source.
/// @throws laplacian_lines::Error(InvalidOption) if those of the title lack, with what to do
/// instead.
std::vector<std::string> checkTexts(const SheetOptions& options, SheetFormat format);

/// The strokes that a kind of file can have: programs that read DXF draw lines of even width.
StrokeStyle strokesIn(const std::string& file, StrokeStyle wanted);

}  // namespace line_drawing
