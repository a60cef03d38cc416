// SPDX-License-Identifier: GPL-3.0-or-later
#include "view_properties.h"

#include <QPainter>

// Each redraw of a view has a painter of its own, and nothing draws with its background brush. No
// widget gives its painter one of this pattern.
bool beginsRedraw(QPainter* painter) {
    if (!painter) return true;
    const QBrush mark(Qt::white, Qt::Dense4Pattern);
    if (painter->background() == mark) return false;
    painter->setBackground(mark);
    return true;
}
