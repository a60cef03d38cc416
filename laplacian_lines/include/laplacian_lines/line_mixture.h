// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <string>

#include "laplacian_lines/line_kind.h"

namespace laplacian_lines {

/// Kinds of lines that make a drawing together. Outlines are always among them.
struct LineMixture {
    const char* key;      ///< identifier in scripts, stable between versions
    const char* label;    ///< in dialogs
    LineKindSet kinds;    ///< that are drawn
    LineKindSet colored;  ///< those among them that are drawn in their key_color
};

constexpr LineKindSet only_kinds(std::initializer_list<LineKind> kinds) {
    LineKindSet set;
    for (const LineKind kind : kinds)
        set[kind] = true;
    return set;
}

constexpr LineKindSet outlines_and(std::initializer_list<LineKind> kinds) {
    return only_kinds(kinds) |
           LineKindSet::where([](const LineKindDescription& row) { return row.bounds_form; });
}

/// Kinds with a key_color.
constexpr LineKindSet kinds_with_key_color() {
    return LineKindSet::where([](const LineKindDescription& row) { return row.key_color != 0; });
}

constexpr LineKindSet all_kinds() {
    return LineKindSet::where([](const LineKindDescription&) { return true; });
}

/// Scripts and settings hold the index: new rows come last.
inline constexpr std::array kLineMixtures = {
    LineMixture{
        "laplacian_lines", "Outlines and Laplacian Lines", outlines_and({LineKind::Laplacian}), {}},
    LineMixture{"suggestive_contours",
                "Suggestive Contours",
                outlines_and({LineKind::SuggestiveContour}),
                {}},
    LineMixture{"suggestive_contours_and_highlights", "Suggestive Contours and Highlights",
                outlines_and({LineKind::SuggestiveContour, LineKind::SuggestiveHighlight}),
                only_kinds({LineKind::SuggestiveHighlight})},
    LineMixture{"apparent_ridges", "Apparent Ridges", outlines_and({LineKind::ApparentRidge}), {}},
    LineMixture{"photic_extremum_lines",
                "Photic Extremum Lines",
                outlines_and({LineKind::PhoticExtremum}),
                {}},
    LineMixture{"ridges_and_valleys",
                "Ridges and Valleys",
                outlines_and({LineKind::Ridge, LineKind::Valley}),
                {}},
    LineMixture{
        "demarcating_curves", "Demarcating Curves", outlines_and({LineKind::DemarcatingCurve}), {}},
    LineMixture{"all_kinds", "All Kinds, in Colors", all_kinds(), kinds_with_key_color()},
};

/// By key or label, whatever the case, blanks and underscores. Null if there is none.
const LineMixture* mixture_named(const std::string& name);

/// The kinds in a list of mixtures and kinds, by key or label as above, with + or commas between
/// them; always with the outlines. "usual" is what is drawn by default. Nothing if a name is not
/// known. Thread-safe.
std::optional<LineKindSet> kinds_named(const std::string& names);

/// All keys that kinds_named() knows, separated by commas.
std::string names_of_kinds();

}  // namespace laplacian_lines
