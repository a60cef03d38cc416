// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainter>

/// Whether this is the first call for a redraw of a view. `painter` of the redraw; it remembers the
/// call. Without a painter each call counts as the first one.
inline bool beginsRedraw(QPainter* painter) {
    if (!painter) return true;
    // Each redraw of a view has a painter of its own, and nothing draws with its background brush.
    // No widget gives its painter one of this pattern.
    const QBrush mark(Qt::white, Qt::Dense4Pattern);
    if (painter->background() == mark) return false;
    painter->setBackground(mark);
    return true;
}

/// Properties of the widget of a view, for pictures. A number: lines are drawn so many times as
/// wide as the parameters say, where the picture is larger than a view usually is in a window.
constexpr const char* line_scale_property = "laplacian_lines_scale";
/// If true, redraws wait for what they otherwise have computed in the background.
constexpr const char* waits_property = "laplacian_lines_waits";
