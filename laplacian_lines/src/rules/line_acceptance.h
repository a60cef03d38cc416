// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/line_set.h"
#include "rules/line_rules.h"

namespace laplacian_lines {

/// Whether the rules on whole lines keep this one; means along it have told of its slope where
/// LineRules::whole.
inline bool accepts(const LineRules& rules, const Polyline& line) {
    return line.length >= rules.least_length && line.strength >= rules.least_strength &&
           (!rules.use_slope || rules.whole || line.slope >= rules.line_slope);
}

}  // namespace laplacian_lines
