// SPDX-License-Identifier: GPL-3.0-or-later
#include <QBuffer>
#include <QFont>
#include <QPainter>
#include <QPdfWriter>
#include <QTransform>

#include "sheet_writers.h"

namespace line_drawing {
namespace {

constexpr int dots_per_inch = 1200;
constexpr double mm_per_inch = 25.4;

void paint(const SheetPath& path, QPainter& painter) {
    if (path.pen_width == 0)
        painter.fillPath(path.path, Qt::black);
    else
        painter.strokePath(path.path,
                           {Qt::black, path.pen_width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin});
}

/// Outlines: a font of this machine need not be on another.
void paint(const SheetText& text, QPainter& painter) {
    constexpr int pixels = 100;
    QFont font("sans-serif");
    font.setPixelSize(pixels);
    QPainterPath letters;
    letters.addText(0, 0, font, text.text);
    const double width = letters.boundingRect().right();
    const double shift = text.alignment == Qt::AlignRight     ? width
                         : text.alignment == Qt::AlignHCenter ? width / 2
                                                              : 0;
    const double size = text.height / pixels;
    painter.fillPath(
        QTransform(size, 0, 0, size, text.position.x() - size * shift, text.position.y())
            .map(letters),
        Qt::black);
}

/// The writer notes the time, by which equal drawings would differ.
void forgetTime(QByteArray& pdf) {
    const QByteArray key = "/CreationDate (D:";
    const int place = pdf.indexOf(key) + key.size();
    if (place < key.size()) return;
    const QByteArray date = "20000101000000";
    if (pdf.indexOf(')', place) >= place + date.size()) pdf.replace(place, date.size(), date);
}

}  // namespace

QByteArray writePdf(const Sheet& sheet) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&buffer);
        writer.setCreator("Laplacian Lines");
        writer.setTitle(sheet.title);
        writer.setResolution(dots_per_inch);
        writer.setPageSize(
            QPageSize(sheet.size, QPageSize::Millimeter, QString(), QPageSize::ExactMatch));
        writer.setPageMargins({0, 0, 0, 0});
        QPainter painter(&writer);
        painter.scale(dots_per_inch / mm_per_inch, dots_per_inch / mm_per_inch);
        for (const SheetGroup& group : sheet.groups)
            for (const SheetLayer& layer : group.layers) {
                for (const SheetPath& path : layer.paths)
                    paint(path, painter);
                for (const SheetText& text : layer.texts)
                    paint(text, painter);
            }
    }
    QByteArray pdf = buffer.data();
    forgetTime(pdf);
    return pdf;
}

}  // namespace line_drawing
