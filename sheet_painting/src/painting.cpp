// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet_painting/painting.h"

#include <QFont>
#include <QFontMetricsF>
#include <QPen>

namespace sheet_painting {
namespace {

using line_drawing::SheetPath;
using line_drawing::SheetText;

constexpr int pixels = 100;  // of letters, before they are scaled

QFont lettering() {
    QFont font("sans-serif");
    font.setPixelSize(pixels);
    return font;
}

Eigen::Vector2d placeOf(const QPainterPath::Element& element) {
    return {element.x / pixels, element.y / pixels};
}

QPointF inQt(const Eigen::Vector2d& p) {
    return {p.x(), p.y()};
}

void paint(const SheetPath& path, QPainter& painter) {
    if (path.pen_width == 0)
        return painter.fillPath(painterPath(path.path),
                                QColor::fromRgbF(path.tone, path.tone, path.tone));
    QPen pen(Qt::black, path.pen_width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    if (path.dash > 0) {
        const double in_pens = path.dash / path.pen_width;
        pen.setDashPattern({in_pens, in_pens / 2});
        pen.setCapStyle(Qt::FlatCap);
    }
    painter.strokePath(painterPath(path.path), pen);
}

void paint(const SheetText& text, QPainter& painter) {
    const QFont font = lettering();
    const QString letters = QString::fromStdString(text.text);
    const double width = QFontMetricsF(font).horizontalAdvance(letters);
    const double size = text.height / pixels;
    painter.save();
    painter.translate(inQt(text.begin(size * width)));
    painter.scale(size, size);
    painter.setFont(font);
    painter.setPen(Qt::black);
    painter.drawText(QPointF(0, 0), letters);
    painter.restore();
}

}  // namespace

QPainterPath painterPath(const line_drawing::Path& path) {
    using Step = line_drawing::Path::Step;
    QPainterPath result;
    for (const auto& piece : path.pieces)
        if (piece.step == Step::Move)
            result.moveTo(inQt(piece.end));
        else if (piece.step == Step::Line)
            result.lineTo(inQt(piece.end));
        else
            result.cubicTo(inQt(piece.first), inQt(piece.second), inQt(piece.end));
    const bool is_even_odd = path.fill_rule == line_drawing::FillRule::EvenOdd;
    result.setFillRule(is_even_odd ? Qt::OddEvenFill : Qt::WindingFill);
    return result;
}

line_drawing::Path outlinesOf(const std::string& text) {
    QPainterPath letters;
    letters.addText(0, 0, lettering(), QString::fromStdString(text));
    line_drawing::Path result;
    result.fill_rule = line_drawing::FillRule::NonZero;
    for (int i = 0; i < letters.elementCount(); ++i) {
        const QPainterPath::Element element = letters.elementAt(i);
        if (element.isMoveTo()) {
            result.moveTo(placeOf(element));
        } else if (element.isLineTo()) {
            result.lineTo(placeOf(element));
        } else {
            result.curveTo(placeOf(element), placeOf(letters.elementAt(i + 1)),
                           placeOf(letters.elementAt(i + 2)));
            i += 2;
        }
    }
    return result;
}

void paint(const line_drawing::Sheet& sheet, QPainter& painter) {
    for (const line_drawing::SheetGroup& group : sheet.groups)
        for (const line_drawing::SheetLayer& layer : group.layers) {
            for (const SheetPath& path : layer.paths)
                paint(path, painter);
            for (const SheetText& text : layer.texts)
                paint(text, painter);
        }
}

}  // namespace sheet_painting
