// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <array>

#include "laplacian_lines/line_kind.h"
#include "line_renderer/line_appearance.h"

using ColorsOfKinds = std::array<QColor, laplacian_lines::line_kind_count>;

ColorsOfKinds keyColors();

/// Kinds that always have their own color.
laplacian_lines::LineKindSet usuallyColored();

/// The user's looks for inner lines and outlines.
struct LineChoice {
    QColor color{describe(laplacian_lines::LineKind::Laplacian).color};
    QColor outline_color{describe(laplacian_lines::LineKind::Contour).color};
    ColorsOfKinds own = keyColors();
    laplacian_lines::LineKindSet colored = usuallyColored();  ///< have their own
    double width = line_renderer::usual_line_width;  ///< pixels, of a Laplacian line of full weight
    double outline_factor = describe(laplacian_lines::LineKind::Contour).width;
};

/// Widths are in the proportions of laplacian_lines::line_kinds. The color is that of inner lines
/// or outlines, unless the kind is colored or was given another than its key color.
line_renderer::LineLook lookOf(const laplacian_lines::LineKindDescription& kind,
                               const LineChoice& choice);

line_renderer::LineLooks looksOf(const LineChoice& choice);
