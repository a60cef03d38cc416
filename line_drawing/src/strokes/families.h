// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "strokes/drawn_lines.h"
#include "views/drawn_view.h"

namespace line_drawing {

/// Calls `keep` with the number of each line, once, which says whether the line is drawn whole:
/// in the order that they have, but from a line that is drawn on to the one on each side, as long
/// nearly and three quarters as strong as the first at least, that is nearest beyond `white`, mm
/// from middle to middle. Of folds nearer to each other every second, or third, is so drawn.
/// @param strengths of the lines, which are in their order, the largest first.
void forEachByFamilies(const std::vector<DrawnLine>& lines, const std::vector<double>& strengths,
                       double white, const std::function<bool(std::size_t)>& keep);

/// Whether a line stands between two of a family of three folds at even distances which go on side
/// by side beyond its ends, for a third of its length at least, with nothing between them: less
/// than four √h from each other they are even without it. `kept`: those that are drawn; `pen` of
/// inner lines, mm.
bool isBetweenFolds(const DrawnLine& line, const DrawnLines& kept, double pen);

}  // namespace line_drawing
