// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "strokes/drawn_lines.h"
#include "views/drawn_view.h"

namespace line_drawing {

/// Calls `keep` once with the number of each line; it returns whether the line is drawn whole. In
/// order of `strengths`, largest first, but a drawn line is followed by its nearest neighbour to
/// each side beyond `white`, mm between middles, that is nearly as long and at least three quarters
/// as strong as the first: so every second or third of close folds is drawn.
void forEachByFamilies(const std::vector<DrawnLine>& lines, const std::vector<double>& strengths,
                       double white, const std::function<bool(std::size_t)>& keep);

/// Whether a line stands in the middle of three evenly spaced folds that go on side by side beyond
/// its ends, for a third of its length, with nothing between them. Folds less than four √h apart
/// are even anyway. `kept`: drawn lines; `pen` of inner lines, mm.
bool isBetweenFolds(const DrawnLine& line, const DrawnLines& kept, double pen);

}  // namespace line_drawing
