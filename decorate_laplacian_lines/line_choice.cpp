// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_choice.h"

#include <algorithm>

using laplacian_lines::LineKind;
using laplacian_lines::LineKindDescription;
using line_renderer::LineLook;
using line_renderer::LineLooks;

ColorsOfKinds keyColors() {
    ColorsOfKinds colors;
    std::transform(laplacian_lines::line_kinds.begin(), laplacian_lines::line_kinds.end(),
                   colors.begin(),
                   [](const LineKindDescription& kind) { return QColor(kind.key_color); });
    return colors;
}

laplacian_lines::LineKindSet usuallyColored() {
    return laplacian_lines::LineKindSet::where(
        [](const LineKindDescription& kind) { return kind.color != 0; });
}

LineLook lookOf(const LineKindDescription& kind, const LineChoice& choice) {
    const LineKindDescription& model =
        describe(kind.is_outline ? LineKind::Contour : LineKind::Laplacian);
    const QColor& common = kind.is_outline ? choice.outline_color : choice.color;
    const QColor& own = choice.own.at(std::size_t(kind.kind));
    const double factor = kind.is_outline ? choice.outline_factor : 1;
    return {choice.colored[kind.kind] || own != QColor(kind.key_color) ? own : common,
            choice.width * factor * (kind.width / model.width)};
}

LineLooks looksOf(const LineChoice& choice) {
    LineLooks looks;
    std::transform(laplacian_lines::line_kinds.begin(), laplacian_lines::line_kinds.end(),
                   looks.begin(),
                   [&](const LineKindDescription& kind) { return lookOf(kind, choice); });
    return looks;
}
