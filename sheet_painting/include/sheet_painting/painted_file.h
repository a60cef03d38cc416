// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "line_drawing/sheet.h"

namespace sheet_painting {

/// Writes a sheet as SVG, PDF, DXF or PNG, by the ending of the file's name, so that a millimetre
/// of the sheet is one of the file, as line_drawing::writeWhole() does. The same sheet gives the
/// same bytes. PNG has `dpi` dots per inch and needs a
/// QGuiApplication, for its fonts; so does PDF with letters that its standard fonts do not have.
/// @throws laplacian_lines::Error(InvalidOption): unknown ending, or the file cannot be written.
void writeSheet(const line_drawing::Sheet& sheet, const QString& file, double dpi = 300);

/// Before much work is done: whether writeSheet() knows the ending and can write there.
/// @throws laplacian_lines::Error(InvalidOption)
void checkSheetFile(const QString& file);

/// Black on white with `dpi` dots per inch.
/// @throws laplacian_lines::Error(InvalidOption) if that is too large.
std::string writePng(const line_drawing::Sheet& sheet, double dpi);

}  // namespace sheet_painting
