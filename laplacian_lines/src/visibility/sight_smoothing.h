// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/line_visibility.h"

namespace laplacian_lines {

/// Passes of binomial smoothing, as of smooth_positions(): exact points and open ends stay.
void smooth_between_exact(int passes, SightLine& line);

}  // namespace laplacian_lines
