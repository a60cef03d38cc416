// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/line_style.h"
#include "rules/line_rules.h"

namespace laplacian_lines {

/// The rules of occluding contours.
LineRules contour_rules(const LineStyle& style);

}  // namespace laplacian_lines
