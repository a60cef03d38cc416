// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "laplacian_lines/line_style.h"

namespace benchmarks {

struct NamedStyle {
    std::string key, text;  ///< names for programs and for people
    laplacian_lines::LineStyle style;
};

/// A kind alone, all else at its default.
NamedStyle only(laplacian_lines::LineKind kind);

/// Contours, then each other kind whose redraws take time worth telling, then the default style and
/// that of all kinds.
std::vector<NamedStyle> kind_styles();

}  // namespace benchmarks
