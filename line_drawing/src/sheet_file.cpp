// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/sheet_file.h"

#include <QFileInfo>
#include <QGuiApplication>
#include <QSaveFile>

#include "sheet_writers.h"
#include "words.h"

namespace line_drawing {
namespace {

using Writer = QByteArray (*)(const Sheet&);

QString endingOf(const QString& file) {
    return QFileInfo(file).suffix().toLower();
}

Writer writerOf(const QString& file) {
    const QString ending = endingOf(file);
    if (ending == "svg") return writeSvg;
    if (ending == "pdf") {
        if (!qobject_cast<QGuiApplication*>(QCoreApplication::instance()))
            refuse("PDF needs fonts, which this program has none of. Write an SVG or DXF file.");
        return writePdf;
    }
    if (ending == "dxf") return writeDxf;
    refuse(
        QString("\"%1\" does not end in .svg, .pdf or .dxf, which say what kind of file to write.")
            .arg(file));
}

void open(QSaveFile& output) {
    if (!output.open(QIODevice::WriteOnly))
        refuse(
            QString("\"%1\" cannot be written: %2").arg(output.fileName(), output.errorString()));
}

}  // namespace

void checkSheetFile(const QString& file) {
    writerOf(file);
    QSaveFile output(file);
    open(output);
    output.cancelWriting();
}

StrokeStyle strokesIn(const QString& file, StrokeStyle wanted) {
    return endingOf(file) == "dxf" ? StrokeStyle::Plain : wanted;
}

void writeSheet(const Sheet& sheet, const QString& file) {
    const QByteArray data = writerOf(file)(sheet);
    QSaveFile output(file);
    open(output);
    output.write(data);
    if (!output.commit())
        refuse(QString("\"%1\" cannot be written: %2").arg(file, output.errorString()));
}

}  // namespace line_drawing
