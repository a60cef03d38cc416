// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/line_set.h"
#include "rules/line_rules.h"

namespace laplacian_lines {

inline bool accepts(const LineRules& rules, const Polyline& line) {
    return line.length >= rules.least_length && line.strength >= rules.least_strength &&
           (!rules.use_slope || line.slope >= rules.line_slope);
}

}  // namespace laplacian_lines
