// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/sheet_file.h"

#include "formats/sheet_writers.h"
#include "line_drawing/words.h"

namespace line_drawing {

SheetFormat formatOf(const std::string& file) {
    const std::string name = lower(file);
    if (endsWith(name, ".svg")) return SheetFormat::Svg;
    if (endsWith(name, ".pdf")) return SheetFormat::Pdf;
    if (endsWith(name, ".dxf")) return SheetFormat::Dxf;
    if (endsWith(name, ".png")) return SheetFormat::Png;
    refuse("\"" + file +
           "\" does not end in .svg, .pdf, .dxf or .png, which say what kind of file to write.");
}

std::string writeSheet(const Sheet& sheet, SheetFormat format, const LetterOutlines& outlines) {
    if (format == SheetFormat::Svg) return writeSvg(sheet);
    if (format == SheetFormat::Dxf) return writeDxf(sheet);
    if (format == SheetFormat::Pdf) return writePdf(sheet, outlines);
    refuse(
        "PNG files are painted by the command and by MeshLab. Write a PDF file here, and turn it "
        "into PNG by pdftoppm or the like.");
}

StrokeStyle strokesIn(const std::string& file, StrokeStyle wanted) {
    return endsWith(lower(file), ".dxf") ? StrokeStyle::Plain : wanted;
}

}  // namespace line_drawing
