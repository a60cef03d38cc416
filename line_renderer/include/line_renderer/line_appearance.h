// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <array>

#include "laplacian_lines/line_kind.h"

namespace line_renderer {

/// How lines of one kind look.
struct LineLook {
    QColor color;
    double width = 0;  ///< pixels, of a line of full weight
};
/// One for each of laplacian_lines::line_kinds, in their order.
using LineLooks = std::array<LineLook, laplacian_lines::line_kind_count>;

/// Width of a Laplacian line of full weight unless another is asked for, pixels.
constexpr double usual_line_width = 1.6;

/// The colors and widths of laplacian_lines::line_kinds.
LineLooks usualLooks();

/// What is drawn of the parts of lines that the surface hides.
enum class HiddenLines { LeftOut, Faint, Dashed };

/// How lines look.
struct LineAppearance {
    LineLooks looks = usualLooks();
    HiddenLines hidden = HiddenLines::LeftOut;
};

}  // namespace line_renderer
