// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "crossings.h"
#include "laplacian_lines/line_set.h"

namespace laplacian_lines {

/// Weights and opacities of a traced line. On entry `points` holds, for each point, the sum of the
/// slopes of its segments in `weight` and the fading of its crossing in `opacity`; positions are
/// local.
void taper_line(const LineRules& rules, const Polyline& line, LinePoint* points);

}  // namespace laplacian_lines
