// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QPainter;

/// Whether this is the first call for a redraw of a view. `painter` of the redraw; it remembers the
/// call. Without a painter each call counts as the first one.
bool beginsRedraw(QPainter* painter);
