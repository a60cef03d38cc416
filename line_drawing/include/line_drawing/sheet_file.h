// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "line_drawing/sheet.h"
#include "line_drawing/sheet_options.h"

namespace line_drawing {

/// Writes a sheet as SVG, PDF, DXF or PNG, by the ending of the file's name, so that a millimetre
/// of the sheet is one of the file, as writeWhole() does. The same sheet gives the same bytes. PNG
/// has `dpi` dots per inch. PDF and PNG need a QGuiApplication, for its fonts.
/// @throws laplacian_lines::Error(InvalidOption): unknown ending, or the file cannot be written.
void writeSheet(const Sheet& sheet, const QString& file, double dpi = 300);

/// Before much work is done: whether writeSheet() knows the ending and can write there.
/// @throws laplacian_lines::Error(InvalidOption)
void checkSheetFile(const QString& file);

/// The strokes that a kind of file can have: programs that read DXF draw lines of even width.
StrokeStyle strokesIn(const QString& file, StrokeStyle wanted);

}  // namespace line_drawing
