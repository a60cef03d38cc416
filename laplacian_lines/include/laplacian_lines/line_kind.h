// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace laplacian_lines {

/// Files hold the number: new kinds come last.
enum class LineKind : std::uint32_t {
    Laplacian,
    Contour,              ///< where the surface turns away from the eye
    Ridge,                ///< convex crest lines
    Border,               ///< where the surface ends
    Crease,               ///< edges of the mesh that are sharp edges of the form
    Valley,               ///< concave crest lines
    DemarcatingCurve,     ///< where reliefs turn from concave to convex
    SuggestiveContour,    ///< contours of nearby views
    SuggestiveHighlight,  ///< their counterparts on lit sides
    ApparentRidge,        ///< where the view-dependent curvature is largest
    PhoticExtremum,       ///< where the illumination changes most
};

/// Names and defaults of a kind. ASCII.
struct LineKindDescription {
    LineKind kind;
    const char* key;                 ///< identifier in scripts, stable between versions
    const char* label;               ///< its switch in dialogs
    const char* help;                ///< of the switch
    const char* one;                 ///< a line of this kind, within a sentence
    const char* many;                ///< several
    bool bounds_form = false;        ///< an outline or border; others lie within
    bool shown = true;               ///< by default
    bool needs_derivatives = false;  ///< needs Field::has_derivatives()
    /// 0xRRGGBB, of polylines and in Python; the window and drawings have one color for lines.
    std::uint32_t color = 0;
    std::uint32_t key_color = 0;  ///< where many kinds are drawn; 0: the common line color
    double width = 1;             ///< by default, in widths of a Laplacian line of full weight
};

/// One row per kind, in the order of their numbers.
inline constexpr std::array kLineKinds = {
    LineKindDescription{LineKind::Laplacian, "laplacian_lines", "Laplacian Lines",
                        "Folds and feet of forms: where the Laplacian of the shading is zero.",
                        "Laplacian line", "Laplacian lines"},
    LineKindDescription{LineKind::Contour, "contours", "Outlines",
                        "Where the surface turns away from the eye.", "outline", "outlines", true,
                        true, false, 0, 0, 2},
    LineKindDescription{LineKind::Ridge, "ridges", "Ridges",
                        "Convex edges of the form, sharp or rounded.", "ridge", "ridges", false,
                        true, false, 0, 0x7a4b2a},
    LineKindDescription{LineKind::Border, "borders", "Borders", "Of holes and open surfaces.",
                        "border", "borders", true, true, false, 0, 0x6b6b6b, 2},
    LineKindDescription{LineKind::Crease, "creases", "Creases",
                        "Sharp edges of the form, on meshes of few triangles, such as those of "
                        "CAD programs, and of many.",
                        "crease", "creases", false, true, false, 0, 0x4a5b6b},
    LineKindDescription{LineKind::Valley, "valleys", "Valleys",
                        "Concave edges of the form, sharp or rounded: the bottoms of grooves.",
                        "valley", "valleys", false, false, false, 0, 0x1b8a9c},
    LineKindDescription{LineKind::DemarcatingCurve, "demarcating_curves", "Demarcating Curves",
                        "Along which a relief turns most sharply from hollow to "
                        "bulging: its middle height on every flank.",
                        "demarcating curve", "demarcating curves", false, false, true, 0, 0x8a3c93},
    LineKindDescription{LineKind::SuggestiveContour, "suggestive_contours", "Suggestive Contours",
                        "Where outlines would begin if the object turned a little (DeCarlo "
                        "and others 2003).",
                        "suggestive contour", "suggestive contours", false, false, true, 0x1f4e99,
                        0x1f4e99},
    LineKindDescription{
        LineKind::SuggestiveHighlight, "suggestive_highlights", "Suggestive Highlights",
        "Counterparts of suggestive contours where the surface turns "
        "towards the eye (DeCarlo and Rusinkiewicz 2007).",
        "suggestive highlight", "suggestive highlights", false, false, true, 0xd08a1d, 0xd08a1d},
    LineKindDescription{LineKind::ApparentRidge, "apparent_ridges", "Apparent Ridges",
                        "Ridges and valleys of the surface as it is seen from the eye (Judd "
                        "and others 2007).",
                        "apparent ridge", "apparent ridges", false, false, true, 0xa3282f,
                        0xa3282f},
    LineKindDescription{LineKind::PhoticExtremum, "photic_extrema", "Photic Extremum Lines",
                        "Where the shading changes most on its way from dark to bright (Xie "
                        "and others 2007).",
                        "photic extremum line", "photic extremum lines", false, false, true,
                        0x2e7d4f, 0x2e7d4f},
};
inline constexpr std::size_t kLineKindCount = kLineKinds.size();

constexpr const LineKindDescription& describe(LineKind kind) {
    return kLineKinds[static_cast<std::size_t>(kind)];
}

class LineKindSet {
public:
    constexpr LineKindSet() = default;
    /// The kinds whose row of kLineKinds satisfies `holds`.
    template <class Holds>
    static constexpr LineKindSet where(const Holds& holds) {
        LineKindSet set;
        for (const LineKindDescription& row : kLineKinds)
            set[row.kind] = holds(row);
        return set;
    }
    static constexpr LineKindSet defaults() {
        return where([](const LineKindDescription& row) { return row.shown; });
    }

    constexpr bool& operator[](LineKind kind) { return switches_[static_cast<std::size_t>(kind)]; }
    constexpr bool operator[](LineKind kind) const {
        return switches_[static_cast<std::size_t>(kind)];
    }

    constexpr LineKindSet operator|(const LineKindSet& other) const {
        return where(
            [&](const LineKindDescription& row) { return (*this)[row.kind] || other[row.kind]; });
    }

    bool operator==(const LineKindSet& other) const { return switches_ == other.switches_; }

    constexpr bool needs_derivatives() const {
        for (const LineKindDescription& row : kLineKinds)
            if (row.needs_derivatives && (*this)[row.kind]) return true;
        return false;
    }

private:
    std::array<bool, kLineKindCount> switches_{};
};

}  // namespace laplacian_lines
