// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "laplacian_lines/line_set.h"

namespace laplacian_lines {

/// For each point of `lines`, 1 if a line of `others` runs beside it: within the distance, in the
/// points' unit, and at less than 45 degrees. Any number of threads gives the same.
std::vector<std::uint8_t> points_along(const LineSet& lines, const LineSet& others, float distance);

}  // namespace laplacian_lines
