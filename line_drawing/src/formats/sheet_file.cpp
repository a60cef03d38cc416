// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/sheet_file.h"

#include <QFileInfo>
#include <QGuiApplication>

#include "formats/sheet_writers.h"
#include "line_drawing/whole_file.h"
#include "line_drawing/words.h"

namespace line_drawing {
namespace {

enum class Format { Svg, Pdf, Dxf, Png };

QString endingOf(const QString& file) {
    return QFileInfo(file).suffix().toLower();
}

void needFonts() {
    if (!qobject_cast<QGuiApplication*>(QCoreApplication::instance()))
        refuse(
            "PDF and PNG need fonts, which this program does not have. Write an SVG or DXF file.");
}

Format formatOf(const QString& file) {
    const QString ending = endingOf(file);
    if (ending == "svg") return Format::Svg;
    if (ending == "dxf") return Format::Dxf;
    if (ending == "pdf" || ending == "png") {
        needFonts();
        return ending == "pdf" ? Format::Pdf : Format::Png;
    }
    refuse(
        QString("\"%1\" does not end in .svg, .pdf, .dxf or .png, which say what kind of file to "
                "write.")
            .arg(file));
}

QByteArray write(const Sheet& sheet, Format format, double dpi) {
    switch (format) {
        case Format::Svg:
            return writeSvg(sheet);
        case Format::Pdf:
            return writePdf(sheet);
        case Format::Dxf:
            return writeDxf(sheet);
        default:
            return writePng(sheet, dpi);
    }
}

}  // namespace

void checkSheetFile(const QString& file) {
    formatOf(file);
    checkWritable(file);
}

StrokeStyle strokesIn(const QString& file, StrokeStyle wanted) {
    return endingOf(file) == "dxf" ? StrokeStyle::Plain : wanted;
}

void writeSheet(const Sheet& sheet, const QString& file, double dpi) {
    writeWhole(file, write(sheet, formatOf(file), dpi));
}

}  // namespace line_drawing
