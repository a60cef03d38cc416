// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/sheet_file.h"

#include "formats/lettering.h"
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

std::string writeSheet(const Sheet& sheet, SheetFormat format, double dpi) {
    if (format == SheetFormat::Svg) return writeSvg(sheet);
    if (format == SheetFormat::Dxf) return writeDxf(sheet);
    return format == SheetFormat::Pdf ? writePdf(sheet) : writePng(sheet, dpi);
}

void checkTexts(const SheetOptions& options, SheetFormat format) {
    if (format == SheetFormat::Pdf || format == SheetFormat::Png)
        for (const std::string& text : {options.title, options.source})
            letteringOf(oneLine(text));
}

StrokeStyle strokesIn(const std::string& file, StrokeStyle wanted) {
    return endsWith(lower(file), ".dxf") ? StrokeStyle::Plain : wanted;
}

}  // namespace line_drawing
