// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/sheet_file.h"

#include "formats/sheet_writers.h"
#include "line_drawing/words.h"
#include "planes/lettering.h"

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

std::vector<std::string> checkTexts(const SheetOptions& options, SheetFormat format) {
    const bool has_own_letters = format == SheetFormat::Svg || format == SheetFormat::Dxf;
    if (has_own_letters && options.text == TextStyle::Letters) return {};
    const std::string of_title = lackingLetter(oneLine(options.title)),
                      of_source = lackingLetter(oneLine(options.source));
    if (!of_title.empty())
        refuse("PDF and PNG files, and outlines of letters, cannot have the letter \"" + of_title +
               "\" of the title. Write an SVG or DXF file, or take another title.");
    if (of_source.empty()) return {};
    return {"PDF and PNG files, and outlines of letters, cannot have the letter \"" + of_source +
            "\" of \"" + oneLine(options.source) +
            "\": a box stands for each such letter. SVG and DXF files have them."};
}

StrokeStyle strokesIn(const std::string& file, StrokeStyle wanted) {
    return endsWith(lower(file), ".dxf") ? StrokeStyle::Plain : wanted;
}

}  // namespace line_drawing
