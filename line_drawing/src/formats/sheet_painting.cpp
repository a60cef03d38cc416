// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/sheet_painting.h"

#include <QFont>
#include <QFontMetricsF>
#include <QPen>

namespace line_drawing {

QColor grey(double tone) {
    return QColor::fromRgbF(tone, tone, tone);
}

namespace {

void paint(const SheetPath& path, QPainter& painter) {
    if (path.pen_width == 0) return painter.fillPath(path.path, grey(path.tone));
    QPen pen(Qt::black, path.pen_width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    if (path.dash > 0) {
        const double in_pens = path.dash / path.pen_width;
        pen.setDashPattern({in_pens, in_pens / 2});
        pen.setCapStyle(Qt::FlatCap);
    }
    painter.strokePath(path.path, pen);
}

void paint(const SheetText& text, QPainter& painter) {
    constexpr int pixels = 100;
    QFont font("sans-serif");
    font.setPixelSize(pixels);
    font.setLetterSpacing(QFont::AbsoluteSpacing, 0.1);  // without ligatures, which searches miss
    const double width = QFontMetricsF(font).horizontalAdvance(text.text);
    const double shift = text.alignment == Qt::AlignRight     ? width
                         : text.alignment == Qt::AlignHCenter ? width / 2
                                                              : 0;
    const double size = text.height / pixels;
    painter.save();
    painter.translate(text.position);
    painter.scale(size, size);
    painter.setFont(font);
    painter.setPen(Qt::black);
    painter.drawText(QPointF(-shift, 0), text.text);  // as letters, that PDF readers find
    painter.restore();
}

}  // namespace

void paint(const Sheet& sheet, QPainter& painter) {
    for (const SheetGroup& group : sheet.groups)
        for (const SheetLayer& layer : group.layers) {
            for (const SheetPath& path : layer.paths)
                paint(path, painter);
            for (const SheetText& text : layer.texts)
                paint(text, painter);
        }
}

}  // namespace line_drawing
