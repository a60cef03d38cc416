// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "line_drawing/sheet.h"
#include "line_drawing/sheet_options.h"

namespace line_drawing {

enum class SheetFormat { Svg, Pdf, Dxf, Png };

/// By the ending of the file's name.
/// @throws laplacian_lines::Error(InvalidOption) if it is another one.
SheetFormat formatOf(const std::string& file);

/// The outlines of a text, of height 1, from (0, 0) on along its base line, y down.
using LetterOutlines = std::function<Path(const std::string& text)>;

/// A sheet as SVG, PDF or DXF, so that a millimetre of the sheet is one of the file. The same sheet
/// gives the same bytes. `outlines`: of texts with letters that PDF's standard fonts do not have.
/// @throws laplacian_lines::Error(InvalidOption) with what to do instead: PNG, or such letters
/// without outlines.
std::string writeSheet(const Sheet& sheet, SheetFormat format, const LetterOutlines& outlines = {});

/// The strokes that a kind of file can have: programs that read DXF draw lines of even width.
StrokeStyle strokesIn(const std::string& file, StrokeStyle wanted);

}  // namespace line_drawing
