// SPDX-License-Identifier: GPL-3.0-or-later
#include "overrides.h"

#include <algorithm>
#include <set>

#include "decoration_table.h"

namespace {

const Override drawing_style = {"drawing_style", "Drawing Style", "Custom",
                                "The drawing style sets this. Choose Custom to set it here."};
const Override mixture = {
    "lines", "Lines", "Laplacian Lines, as Switched",
    "The choice of lines sets this. Choose Laplacian Lines, as Switched, to set it here."};

bool isSwitchOfKind(const std::string& key) {
    return std::any_of(laplacian_lines::line_kinds.begin(), laplacian_lines::line_kinds.end(),
                       [&](const auto& kind) { return key == kind.key; });
}

/// Null if this is not a color.
const ColorRow* colorRow(const std::string& key) {
    for (const ParameterGroup& group : decorationTable())
        for (const ParameterRow& any : group.rows)
            if (const auto* row = std::get_if<ColorRow>(&any); row && key == row->key) return row;
    return nullptr;
}

/// The mixture needs it to tell a kind from others, in any style.
bool isColorOfMixture(const std::string& key, const DecorationParameters& chosen) {
    const laplacian_lines::LineMixture* lines = mixtureOf(chosen);
    const ColorRow* color = colorRow(key);
    return lines && color && color->kind && lines->colored[*color->kind];
}

}  // namespace

const Override* overrideOf(const std::string& key) {
    static const std::set<std::string> of_style = {"surface", "tones", "background", "light"};
    if (isSwitchOfKind(key)) return &mixture;
    return of_style.count(key) || colorRow(key) ? &drawing_style : nullptr;
}

bool isOverridden(const std::string& key, const DecorationParameters& chosen) {
    const Override* overriding = overrideOf(key);
    if (overriding == &mixture) return mixtureOf(chosen);
    return overriding && chosen.drawing_style != DrawingStyle::Custom &&
           !isColorOfMixture(key, chosen);
}
