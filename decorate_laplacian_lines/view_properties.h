// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainter>

/// Whether this is the first call in a view's redraw; `painter` remembers the call. Without a
/// painter each call is the first.
inline bool begins_redraw(QPainter* painter) {
    if (!painter) return true;
    // Each redraw has its own painter; nothing draws with its background brush or gives it this
    // pattern.
    const QBrush mark(Qt::white, Qt::Dense4Pattern);
    if (painter->background() == mark) return false;
    painter->setBackground(mark);
    return true;
}

/// Properties of a view's widget, for pictures. A factor of the widths of lines, for large
/// pictures.
constexpr const char* line_scale_property = "laplacian_lines_scale";
/// Redraws wait for drawings that are otherwise computed in the background.
constexpr const char* waits_property = "laplacian_lines_waits";
