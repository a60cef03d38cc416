// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/line_set.h"
#include "visibility/line_parts.h"
#include "visibility/line_votes.h"
#include "visibility/picture_crossings.h"
#include "visibility/sight.h"

namespace laplacian_lines {

/// On which side of a contour, in the picture, its own surface is not: +1 right of it, -1 left,
/// whether it is seen or not. By a vote of places along it, since meshes may be inside out and
/// contours along edges run either way.
int free_side(const LineSet& lines, const Polyline& line, const SightLengths& lengths,
              Sight& sight);

/// A line in pieces, and which of them are seen.
struct LineDecision {
    std::vector<LinePart> seen, hidden;
};

/// Decides which parts of a line are seen.
LineDecision decide(const LineSet& lines, const Polyline& line, int free_side,
                    const PictureCrossings& crossings, const SightLengths& lengths, Sight& sight);

}  // namespace laplacian_lines
