// SPDX-License-Identifier: GPL-3.0-or-later
#include "decoration_parameters.h"
#include "laplacian_lines/option_rows.h"

namespace {

using namespace laplacian_lines::option_rows;
using laplacian_lines::LineKind;
using laplacian_lines::LineStyle;
using Parameters = DecorationParameters;
constexpr auto style = &Parameters::style;

std::vector<const char*> mixtureNames() {
    std::vector<const char*> names = {"As Ticked Below"};
    for (const laplacian_lines::LineMixture& mixture : laplacian_lines::line_mixtures)
        names.push_back(mixture.label);
    return names;
}

template <LineKind Kind>
DecorationRow tick() {
    constexpr const laplacian_lines::LineKindDescription& kind = describe(Kind);
    return {kind.key,
            kind.label,
            kind.help,
            laplacian_lines::OptionKind::Boolean,
            0,
            1,
            {},
            [](const Parameters& of) { return of.style.shows[Kind] ? 1. : 0.; },
            [](Parameters& of, double value) { of.style.shows[Kind] = value != 0; }};
}

}  // namespace

const std::vector<std::variant<DecorationRow, ColorRow>>& decorationTable() {
    static const std::vector<std::variant<DecorationRow, ColorRow>> table = {
        choice<&Parameters::drawing_style>(
            "drawing_style", "Drawing Style",
            {"Custom", "Publication (Black on White)", "Archaeology (Side Light)"},
            "Publication: black lines on white paper that fills the view, with the light at the "
            "eye. Archaeology: the same with the light from the upper left, or from where Light "
            "has it. Line Color and Surface count in the style Custom only."),
        choice<&Parameters::mixture>(
            "lines", "Lines", mixtureNames(),
            "The kinds ticked below, or one of the kinds of other papers with the outlines, "
            "whatever is ticked. The last has all at once, each in a color of its own."),
        real<style, &LineStyle::detail>(
            "detail", "Detail", 0, 100,
            "0 to 100: more or fewer lines of all kinds; 50 is the usual."),
        real<&Parameters::line_width>("line_width", "Line Width", 0.1, 64,
                                      "In pixels, where a line is strongest; it tapers where it "
                                      "fades out."),
        real<&Parameters::outline_width>("contour_width_factor", "Outline Width", 0.1, 16,
                                         "Of outlines and borders, in widths of the lines inside."),
        ColorRow{"line_color", "Line Color",
                 "Of all lines but those that Lines tells apart by their colors.",
                 &Parameters::line_color},
        choice<&Parameters::appearance, &line_renderer::LineAppearance::hidden>(
            "hidden_lines", "Hidden Lines", {"Not Drawn", "Faint", "Dashed"},
            "Those behind the surface."),
        choice<&Parameters::scale>(
            "scale", "Scale", {"As Computed", "With the View"},
            "Of the forms that Laplacian lines show. As Computed: the kernel size of the filter "
            "Compute Laplacian Lines, or its default, at any zoom. With the View: what is large "
            "enough to be drawn at this zoom, a kernel of four line widths."),
        tick<LineKind::Contour>(),
        tick<LineKind::Laplacian>(),
        tick<LineKind::Ridge>(),
        tick<LineKind::Crease>(),
        tick<LineKind::Border>(),
        choice<&Parameters::surface>(
            "surface", "Surface",
            {"As MeshLab Draws It", "Paper", "Toon", "As MeshLab Draws It, on Paper"},
            "Paper: nothing but lines on white. Toon: three flat tones, darker where the surface "
            "turns away, on white."),
        choice<&Parameters::light>(
            "light", "Light",
            {"At the Eye", "From the Upper Left", "From Above", "From the Upper Right",
             "From the Right", "From the Lower Right", "From Below", "From the Lower Left",
             "From the Left"},
            "Whose shading the Laplacian lines draw. All but the first turn with the camera, 45 "
            "degrees above the plane of the picture. Outlines follow the eye."),
        boolean<&Parameters::show_statistics>(
            "show_statistics", "Show Statistics",
            "In the view: the number of lines; milliseconds to find them (extraction), to hand "
            "them to OpenGL (upload), to tell it what to draw (draw calls) and of its own "
            "drawing; seconds that switching them on took."),
        real<style, &LineStyle::gradient_threshold>(
            "gradient_threshold", "Gradient Threshold t", 0, 1e6,
            "Least change of the shading across a line: its gradient times the diagonal of the "
            "bounding box, without a unit. Larger leaves out lines on gentle forms."),
        real<style, &LineStyle::strength_threshold>(
            "strength_threshold", "Strength Threshold tau", 0, 1e6,
            "Least strength of a line: its gradient summed along its length, without a unit. "
            "Larger leaves out short and weak lines."),
    };
    return table;
}
