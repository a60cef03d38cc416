// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainter>

/// Whether this is the first call in the redraw that `painter` draws. MeshLab calls a decoration
/// once for each layer and does not say which layer comes first, but each redraw has a painter of
/// its own: the first call marks it, by a background brush that nothing else sets and nothing draws
/// with. Without a painter each call is the first.
inline bool begins_redraw(QPainter* painter) {
    if (!painter) return true;
    const QBrush mark(Qt::white, Qt::Dense4Pattern);
    if (painter->background() == mark) return false;
    painter->setBackground(mark);
    return true;
}
