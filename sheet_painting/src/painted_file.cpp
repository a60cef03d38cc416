// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet_painting/painted_file.h"

#include <QGuiApplication>

#include "line_drawing/sheet_file.h"
#include "line_drawing/whole_file.h"
#include "sheet_painting/qt_words.h"

namespace sheet_painting {
namespace {

using line_drawing::SheetFormat;

bool isPainted(SheetFormat format) {
    return format == SheetFormat::Pdf || format == SheetFormat::Png;
}

void needFonts() {
    if (!qobject_cast<QGuiApplication*>(QCoreApplication::instance()))
        refuse(
            "PDF and PNG need fonts, which this program does not have. Write an SVG or DXF file.");
}

}  // namespace

void checkSheetFile(const QString& file) {
    const std::string name = fileName(file);
    if (isPainted(line_drawing::formatOf(name))) needFonts();
    line_drawing::checkWritable(name);
}

void writeSheet(const line_drawing::Sheet& sheet, const QString& file, double dpi) {
    const std::string name = fileName(file);
    const SheetFormat format = line_drawing::formatOf(name);
    if (isPainted(format)) needFonts();
    line_drawing::writeWhole(name, format == SheetFormat::Pdf   ? writePdf(sheet)
                                   : format == SheetFormat::Png ? writePng(sheet, dpi)
                                                                : writeSheet(sheet, format));
}

}  // namespace sheet_painting
