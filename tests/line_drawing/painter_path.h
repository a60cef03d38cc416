// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainterPath>

#include "line_drawing/path.h"

/// Qt's path, which measures independently.
inline QPainterPath painterPath(const line_drawing::Path& path) {
    using Step = line_drawing::Path::Step;
    const auto in_qt = [](const Eigen::Vector2d& p) { return QPointF(p.x(), p.y()); };
    QPainterPath result;
    for (const auto& piece : path.pieces)
        if (piece.step == Step::Move)
            result.moveTo(in_qt(piece.end));
        else if (piece.step == Step::Line)
            result.lineTo(in_qt(piece.end));
        else
            result.cubicTo(in_qt(piece.first), in_qt(piece.second), in_qt(piece.end));
    const bool is_even_odd = path.fill_rule == line_drawing::FillRule::EvenOdd;
    result.setFillRule(is_even_odd ? Qt::OddEvenFill : Qt::WindingFill);
    return result;
}
