// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

#include "laplacian_lines/line_kind.h"
#include "line_renderer/line_appearance.h"

/// What the user chooses of how lines look: of those inside the form, and of its outlines.
struct LineChoice {
    QColor color{describe(laplacian_lines::LineKind::Laplacian).color};
    QColor outline_color{describe(laplacian_lines::LineKind::Contour).color};
    double width = line_renderer::usual_line_width;  ///< pixels, of a Laplacian line of full weight
    /// Width of contours in widths of Laplacian lines.
    double outline_factor = describe(laplacian_lines::LineKind::Contour).width;
};

/// The look of a kind. Widths stay in the proportions of laplacian_lines::line_kinds; a kind that
/// has another color there than Laplacian lines, or contours if it is an outline, keeps it.
line_renderer::LineLook lookOf(const laplacian_lines::LineKindDescription& kind,
                               const LineChoice& choice);

/// Those of all kinds.
line_renderer::LineLooks looksOf(const LineChoice& choice);
