// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <array>

#include "laplacian_lines/line_kind.h"
#include "line_renderer/line_appearance.h"

/// By the number of the kind.
using ColorsOfKinds = std::array<QColor, laplacian_lines::line_kind_count>;

ColorsOfKinds keyColors();

/// Kinds that have a color of their own wherever they are switched on.
laplacian_lines::LineKindSet usuallyColored();

/// What the user chooses of how lines look: of those inside the form, and of its outlines.
struct LineChoice {
    QColor color{describe(laplacian_lines::LineKind::Laplacian).color};
    QColor outline_color{describe(laplacian_lines::LineKind::Contour).color};
    ColorsOfKinds own = keyColors();
    laplacian_lines::LineKindSet colored = usuallyColored();  ///< have their own
    double width = line_renderer::usual_line_width;  ///< pixels, of a Laplacian line of full weight
    /// Width of contours in widths of Laplacian lines.
    double outline_factor = describe(laplacian_lines::LineKind::Contour).width;
};

/// The look of a kind. Widths stay in the proportions of laplacian_lines::line_kinds. A kind has
/// the color of the lines inside the form, or of outlines, unless it is colored or has been given
/// another than its key color.
line_renderer::LineLook lookOf(const laplacian_lines::LineKindDescription& kind,
                               const LineChoice& choice);

/// Those of all kinds.
line_renderer::LineLooks looksOf(const LineChoice& choice);
