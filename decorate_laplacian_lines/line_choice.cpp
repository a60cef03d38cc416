// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_choice.h"

#include <algorithm>

using laplacian_lines::LineKind;
using laplacian_lines::LineKindDescription;
using line_renderer::LineLook;
using line_renderer::LineLooks;

LineLook lookOf(const LineKindDescription& kind, const LineChoice& choice) {
    const LineKindDescription& model =
        describe(kind.is_outline ? LineKind::Contour : LineKind::Laplacian);
    const QColor& chosen = kind.is_outline ? choice.outline_color : choice.color;
    const double factor = kind.is_outline ? choice.outline_factor : 1;
    return {kind.color == model.color ? chosen : QColor(kind.color),
            choice.width * factor * (kind.width / model.width)};
}

LineLooks looksOf(const LineChoice& choice) {
    LineLooks looks;
    std::transform(laplacian_lines::line_kinds.begin(), laplacian_lines::line_kinds.end(),
                   looks.begin(),
                   [&](const LineKindDescription& kind) { return lookOf(kind, choice); });
    return looks;
}
