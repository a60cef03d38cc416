// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <array>

#include "laplacian_lines/line_kind.h"

namespace line_renderer {

struct LineLook {
    QColor color;
    double width = 0;         ///< pixels, of a line of full weight
    double share_within = 1;  ///< factor of the width where there is a surface on both sides
};
/// In the order of laplacian_lines::kLineKinds.
using LineLooks = std::array<LineLook, laplacian_lines::kLineKindCount>;

/// Default width of a Laplacian line of full weight, pixels.
constexpr double kUsualLineWidth = 1.6;

/// What is drawn of hidden parts of lines.
enum class HiddenLines { LeftOut, Faint, Dashed };
constexpr double kFaintAlpha = 0.25;

struct LineAppearance {
    LineLooks looks;
    HiddenLines hidden = HiddenLines::LeftOut;
};

}  // namespace line_renderer
