// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "line_drawing/sheet_file.h"

namespace line_drawing {

/// Calls mark(path or text, its group, its layer) for all of a sheet in their order.
template <class Mark>
void forEachMark(const Sheet& sheet, const Mark& mark) {
    for (const SheetGroup& group : sheet.groups)
        for (const SheetLayer& layer : group.layers) {
            for (const SheetPath& path : layer.paths)
                mark(path, group, layer);
            for (const SheetText& text : layer.texts)
                mark(text, group, layer);
        }
}

/// SVG 1.1 whose user unit is a millimetre; groups and layers are Inkscape's layers.
std::string writeSvg(const Sheet& sheet);
/// PDF of one page in the standard fonts, which are not in the file; texts with other letters are
/// outlines.
std::string writePdf(const Sheet& sheet);
/// PNG, black on white, of 256 grays.
/// @throws laplacian_lines::Error(InvalidOption) if it would be too large.
std::string writePng(const Sheet& sheet, double dpi);
/// DXF R12 in millimetres, y up; polylines, in a layer for each class of lines. Filled areas are
/// drawn by their outlines.
std::string writeDxf(const Sheet& sheet);

}  // namespace line_drawing
