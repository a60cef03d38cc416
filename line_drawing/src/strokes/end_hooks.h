// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "views/drawn_view.h"

namespace line_drawing {

/// Cuts off ends of inner lines that bend aside: a zero of the Laplacian goes on there around the
/// end of the feature, which an illustrator does not. Ends that meet another line stay. `pen`: of
/// inner lines, mm.
void cutHooks(std::vector<DrawnLine>& lines, double pen);

}  // namespace line_drawing
