// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include "line_drawing/sheet.h"

namespace line_drawing {

/// SVG 1.1 whose user unit is a millimetre; groups and layers are Inkscape's layers.
QByteArray writeSvg(const Sheet& sheet);
/// PDF of one page; text as outlines.
QByteArray writePdf(const Sheet& sheet);
/// Black on white with `dpi` dots per inch.
/// @throws laplacian_lines::Error(InvalidOption) if that is too large.
QByteArray writePng(const Sheet& sheet, double dpi);
/// DXF R12 in millimetres, y up; polylines, in a layer for each class of lines. Filled areas are
/// drawn by their outlines.
QByteArray writeDxf(const Sheet& sheet);

}  // namespace line_drawing
