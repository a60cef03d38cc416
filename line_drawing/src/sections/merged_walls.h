// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/drawn_view.h"

namespace line_drawing {

/// What a plane cuts of an object.
struct CutObject {
    Wall wall = {};
    std::vector<DrawnLine> lines = {};
};

/// Adds walls and lines to a view. Walls that overlap are merged: their lines end where they go
/// into another one. Those that only touch, or overlap by as little as scans of parts that fit, are
/// walls of their own.
void addWalls(const std::vector<CutObject>& objects, DrawnView& drawn);

}  // namespace line_drawing
