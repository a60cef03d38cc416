// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet_painting/painted_file.h"

#include <QGuiApplication>

#include "line_drawing/sheet_file.h"
#include "line_drawing/whole_file.h"
#include "sheet_painting/painting.h"
#include "sheet_painting/qt_words.h"

namespace sheet_painting {
namespace {

using line_drawing::SheetFormat;

bool hasFonts() {
    return qobject_cast<QGuiApplication*>(QCoreApplication::instance());
}

void check(SheetFormat format) {
    if (format == SheetFormat::Png && !hasFonts())
        refuse("PNG needs fonts, which this program does not have. Write a PDF, SVG or DXF file.");
}

}  // namespace

void checkSheetFile(const QString& file) {
    const std::string name = fileName(file);
    check(line_drawing::formatOf(name));
    line_drawing::checkWritable(name);
}

void writeSheet(const line_drawing::Sheet& sheet, const QString& file, double dpi) {
    const std::string name = fileName(file);
    const SheetFormat format = line_drawing::formatOf(name);
    check(format);
    line_drawing::writeWhole(
        name,
        format == SheetFormat::Png
            ? writePng(sheet, dpi)
            : writeSheet(sheet, format, hasFonts() ? outlinesOf : line_drawing::LetterOutlines()));
}

}  // namespace sheet_painting
