// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/line_kind.h"
#include "laplacian_lines/line_style.h"
#include "rules/line_rules.h"

namespace laplacian_lines {

/// Which zeros of one of kStripKinds a style shows. Lines of a light that is not at the eye follow
/// no contours.
LineRules strip_rules(LineKind kind, const LineStyle& style, bool light_at_eye);

}  // namespace laplacian_lines
