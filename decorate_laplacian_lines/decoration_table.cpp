// SPDX-License-Identifier: GPL-3.0-or-later
#include "decoration_table.h"

#include "laplacian_lines/option_rows.h"

namespace {

using namespace laplacian_lines::option_rows;
using laplacian_lines::OptionKind;
using line_renderer::LineAppearance;
using line_renderer::SurfaceAppearance;
using Parameters = DecorationParameters;

template <auto... Path>
ColorRow color(const char* key, const char* label, const char* help) {
    return {key, label, help,
            [](Parameters& parameters) -> QColor& { return (parameters.*....*Path); }};
}

ParameterGroup drawing() {
    return {nullptr,
            {choice<&Parameters::drawing_style>(
                "drawing_style", "Drawing Style",
                {"As Set Below", "Publication (Black on White)", "Archaeology (Side Light)"},
                "As Set Below: the colors, surface, background and light of the parameters below. "
                "Publication: black lines on white paper that fills the view, whatever those say. "
                "Archaeology: the same, with the light fixed to the camera, by default on the "
                "upper left. The other parameters count in all styles.")},
            StyleRows::Everyday};
}

ParameterGroup lines() {
    constexpr auto lines = &Parameters::lines;
    return {
        "Lines",
        {real<lines, &LineChoice::width>(
             "line_width", "Line Width", 0.1, 64,
             "Width in pixels of a Laplacian line at its strongest; lines taper where they "
             "fade out."),
         real<lines, &LineChoice::outline_factor>(
             "contour_width_factor", "Contour Width Factor", 0, 16,
             "Width of occluding contours, in widths of Laplacian lines."),
         choice<&Parameters::appearance, &LineAppearance::hidden>(
             "hidden_lines", "Hidden Lines", {"Left Out", "Faint", "Dashed"},
             "What is drawn of lines that the surface hides: nothing, faint lines, or "
             "dashes.")},
        StyleRows::None,
        {color<lines, &LineChoice::color>("line_color", "Line Color", "Color of Laplacian lines."),
         color<lines, &LineChoice::outline_color>(
             "contour_color", "Contour Color",
             "Color of occluding contours, which go around the form.")}};
}

ParameterGroup surface() {
    constexpr auto look = &Parameters::surface;
    return {"Surface and Background",
            {choice<look, &SurfaceAppearance::style>(
                 "surface", "Surface", {"As MeshLab Draws It", "Paper", "Toon"},
                 "What is seen of the surface. Paper: nothing but lines on one plain color. Toon: "
                 "a few flat tones, darker where the surface turns away. Both cover MeshLab's own "
                 "drawing of the layer."),
             row<look, &SurfaceAppearance::tones>(
                 "tones", "Tones", OptionKind::Integer, 2, SurfaceAppearance::most_tones,
                 "Number of tones from shade to paper, 2 to 8 (Toon)."),
             choice<&Parameters::background>("background", "Background",
                                             {"As MeshLab Draws It", "Paper Color"},
                                             "What is seen around the surface.")},
            StyleRows::None,
            {color<look, &SurfaceAppearance::paper>(
                 "paper_color", "Paper Color", "Color of the paper, and of the lightest tone."),
             color<look, &SurfaceAppearance::shade>("shade_color", "Shade Color",
                                                    "Color of the darkest tone (Toon).")}};
}

ParameterGroup light() {
    constexpr auto lamp = &Parameters::camera_light;
    return {"Light",
            {choice<&Parameters::light>(
                 "light", "Light Position", {"At the Eye", "Fixed to the Camera"},
                 "Whose shading the Laplacian lines draw: of a light at the eye, or of a distant "
                 "one that turns with the camera. Contours are the eye's in any case."),
             real<lamp, &meshlab_host::CameraLight::azimuth>(
                 "light_azimuth", "Light Azimuth", -360, 360,
                 "For the light that is fixed to the camera: where in the picture it comes from, "
                 "in degrees clockwise from the top. 0: above, 90: right, 180: below, 270: left, "
                 "315: upper left."),
             real<lamp, &meshlab_host::CameraLight::elevation>(
                 "light_elevation", "Light Elevation", 0, 90,
                 "For the light that is fixed to the camera: its angle above the plane of the "
                 "picture, in degrees. 0: grazing light from the side, 90: from straight behind "
                 "the viewer.")}};
}

ParameterGroup statistics() {
    return {nullptr,
            {boolean<&Parameters::show_statistics>(
                "show_statistics", "Show Statistics",
                "Show in the view the number of lines; the milliseconds of the last redraw to find "
                "them (extraction), to hand them to OpenGL (upload), to tell it what to draw (draw "
                "calls) and of its own drawing; and the seconds that switching them on took.")}};
}

}  // namespace

const std::vector<ParameterGroup>& decorationTable() {
    static const std::vector<ParameterGroup> table = {
        drawing(),   lines(), surface(), light(), {"For Experts", {}, StyleRows::ForExperts},
        statistics()};
    return table;
}
