// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/drawn_view.h"

namespace line_drawing {

struct CutObject {
    Wall wall = {};
    std::vector<DrawnLine> lines = {};
};

/// Adds walls and lines to a view. Merges walls that overlap: their lines end where they enter
/// another. Walls that touch, or overlap as little as scans of fitting parts do, stay apart.
void addWalls(const std::vector<CutObject>& objects, DrawnView& drawn);

}  // namespace line_drawing
