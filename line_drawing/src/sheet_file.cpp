// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/sheet_file.h"

#include <QFileInfo>
#include <QSaveFile>

#include "sheet_writers.h"
#include "words.h"

namespace line_drawing {
namespace {

enum class Format { Svg, Pdf, Dxf, Png };

Format formatOf(const QString& file) {
    const QString ending = QFileInfo(file).suffix().toLower();
    if (ending == "svg") return Format::Svg;
    if (ending == "pdf") return Format::Pdf;
    if (ending == "dxf") return Format::Dxf;
    if (ending == "png") return Format::Png;
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

void open(QSaveFile& output) {
    if (!output.open(QIODevice::WriteOnly))
        refuse(
            QString("\"%1\" cannot be written: %2").arg(output.fileName(), output.errorString()));
}

}  // namespace

void checkSheetFile(const QString& file) {
    formatOf(file);
    QSaveFile output(file);
    open(output);
    output.cancelWriting();
}

void writeSheet(const Sheet& sheet, const QString& file, double dpi) {
    const QByteArray data = write(sheet, formatOf(file), dpi);
    QSaveFile output(file);
    open(output);
    output.write(data);
    if (!output.commit())
        refuse(QString("\"%1\" cannot be written: %2").arg(file, output.errorString()));
}

}  // namespace line_drawing
