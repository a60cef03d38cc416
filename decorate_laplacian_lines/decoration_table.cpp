// SPDX-License-Identifier: GPL-3.0-or-later
#include "decoration_table.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "laplacian_lines/line_mixture.h"
#include "laplacian_lines/option_rows.h"
#include "meshlab_host/parameters.h"

namespace {

using namespace laplacian_lines::option_rows;
using laplacian_lines::LineKind;
using laplacian_lines::OptionKind;
using line_renderer::LineAppearance;
using line_renderer::SurfaceAppearance;
using Parameters = DecorationParameters;

StyleRow style(const std::string& key) {
    for (const StyleRow& row : laplacian_lines::line_style_table())
        if (row.key == key) return row;
    throw std::logic_error("there is no option " + key);
}

template <class Row>
ParameterRow forExperts(Row row) {
    row.for_experts = true;
    return row;
}

std::vector<const char*> mixtureNames() {
    std::vector<const char*> names = {"Laplacian Lines, as Switched"};
    for (const laplacian_lines::LineMixture& mixture : laplacian_lines::line_mixtures)
        names.push_back(mixture.label);
    return names;
}

template <auto... Path>
ColorRow color(const char* key, const char* label, const char* help) {
    return {key, label, help,
            [](Parameters& parameters) -> QColor& { return (parameters.*....*Path); }};
}

constexpr auto line_choice = &Parameters::lines;

/// What the first hour needs.
ParameterGroup everyday() {
    return {
        nullptr,
        {choice<&Parameters::drawing_style>(
             "drawing_style", "Drawing Style",
             {"Custom", "Publication (Black on White)", "Archaeology (Side Light)"},
             "Custom: the colors, surface, background and light that are set here. Publication: "
             "black lines on white paper that fills the view, whatever those say. Archaeology: the "
             "same, with the light fixed to the camera, by default on the upper left. The other "
             "parameters count in all styles."),
         choice<&Parameters::mixture>(
             "lines", "Lines", mixtureNames(),
             "Which kinds of lines are drawn, each with the outlines: those that are switched on, "
             "or one of the kinds of other papers, for comparison. The last has all at once, each "
             "in a color of its own."),
         style("detail"),
         real<line_choice, &LineChoice::width>(
             "line_width", "Line Width", 0.1, 64,
             "Width in pixels of a Laplacian line at its strongest; lines taper where they fade "
             "out."),
         color<line_choice, &LineChoice::color>("line_color", "Line Color",
                                                "Color of Laplacian lines."),
         color<line_choice, &LineChoice::outline_color>(
             "contour_color", "Contour Color",
             "Color of occluding contours, which go around the form."),
         choice<&Parameters::appearance, &LineAppearance::hidden>(
             "hidden_lines", "Hidden Lines", {"Left Out", "Faint", "Dashed"},
             "How lines behind the surface are drawn: not at all, faint, or dashed."),
         choice<&Parameters::scale>(
             "scale", "Scale", {"As Computed", "With the View"},
             "Which detail Laplacian lines show. As Computed: that of the kernel size of Compute "
             "Laplacian Lines, or of the default one, whatever the zoom. With the View: what is "
             "large enough to be drawn at this zoom, a kernel of four line widths; others are "
             "computed in the background as soon as they are needed."),
         style("contours"), style("laplacian_lines"), forExperts(style("single_strokes")),
         forExperts(style("ridges")), style("ridge_angle"), forExperts(style("creases")),
         style("crease_angle"), forExperts(style("borders")),
         choice<&Parameters::shown>(
             "parameters", "Parameters", {"Basic", "All"},
             "Which parameters are shown: those that everybody uses, or also surface, background, "
             "light and what decides which lines are drawn. Those that are not shown keep their "
             "values.")}};
}

/// Highlights need another color on each paper; other kinds tell themselves apart by theirs.
ColorRow highlightColor() {
    return {"highlight_color",
            "Highlight Color",
            "Color of suggestive highlights.",
            [](Parameters& parameters) -> QColor& {
                return parameters.lines.own[std::size_t(LineKind::SuggestiveHighlight)];
            },
            true,
            LineKind::SuggestiveHighlight};
}

ParameterGroup surface() {
    constexpr auto look = &Parameters::surface;
    return {
        "Surface and Background",
        {forExperts(choice<look, &SurfaceAppearance::style>(
             "surface", "Surface", {"As MeshLab Draws It", "Paper", "Toon"},
             "What is seen of the surface. Paper: nothing but lines on one plain color. Toon: a "
             "few flat tones, darker where the surface turns away. Both cover MeshLab's own "
             "drawing of the layer.")),
         forExperts(row<look, &SurfaceAppearance::tones>(
             "tones", "Tones", OptionKind::Integer, 2, SurfaceAppearance::most_tones,
             "Number of tones from shade to paper, 2 to 8 (Toon).")),
         forExperts(choice<&Parameters::background>("background", "Background",
                                                    {"As MeshLab Draws It", "Paper Color"},
                                                    "What is seen around the surface.")),
         forExperts(color<look, &SurfaceAppearance::paper>(
             "paper_color", "Paper Color",
             "Color of the paper, and of the lightest tone; darker ones are shades of it."))}};
}

ParameterGroup light() {
    constexpr auto lamp = &Parameters::camera_light;
    return {"Light",
            {forExperts(choice<&Parameters::light>(
                 "light", "Light Position", {"At the Eye", "Fixed to the Camera"},
                 "Whose shading the Laplacian lines draw: of a light at the eye, or of a distant "
                 "one that turns with the camera. Contours always follow the eye.")),
             forExperts(real<lamp, &meshlab_host::CameraLight::azimuth>(
                 "light_azimuth", "Light Azimuth", -360, 360,
                 "For the light that is fixed to the camera: where in the picture it comes from, "
                 "in degrees clockwise from the top. 0: above, 90: right, 180: below, 270: left, "
                 "315: upper left.")),
             forExperts(real<lamp, &meshlab_host::CameraLight::elevation>(
                 "light_elevation", "Light Elevation", 0, 90,
                 "For the light that is fixed to the camera: its angle above the plane of the "
                 "picture, in degrees. 0: grazing light from the side, 90: from straight behind "
                 "the viewer."))}};
}

bool isListed(const StyleRow& row, const std::vector<ParameterRow>& rows) {
    return std::any_of(rows.begin(), rows.end(), [&](const ParameterRow& other) {
        const auto* listed = std::get_if<StyleRow>(&other);
        return listed && std::string(listed->key) == row.key;
    });
}

/// The rest of the line style.
ParameterGroup experts() {
    ParameterGroup group{"For Experts",
                         {forExperts(real<line_choice, &LineChoice::outline_factor>(
                             "contour_width_factor", "Contour Width Factor", 0, 16,
                             "Width of occluding contours, in widths of Laplacian lines."))}};
    const std::vector<ParameterRow> others = everyday().rows;
    for (const StyleRow& row : laplacian_lines::line_style_table())
        if (!row.instead && !isListed(row, others)) group.rows.push_back(row);
    group.rows.push_back(highlightColor());
    group.rows.push_back(forExperts(boolean<&Parameters::show_statistics>(
        "show_statistics", "Show Statistics",
        "Show in the view the number of lines; the milliseconds of the last redraw to find them "
        "(extraction), to hand them to OpenGL (upload), to tell it what to draw (draw calls) and "
        "of its own drawing; and the seconds that switching them on took.")));
    return group;
}

}  // namespace

const std::vector<ParameterGroup>& decorationTable() {
    static const std::vector<ParameterGroup> table = {everyday(), surface(), light(), experts()};
    return table;
}

std::vector<GoneParameter> goneParameters() {
    std::vector<GoneParameter> gone = {
        {"shade_color", "Shade Color", "#969696", "a shade of Paper Color", "Set that."},
        {"exact_point_light", "Exact Point Light", "off", "off",
         "Lines are those of the paper's form of the Laplacian."},
        {"mesh_silhouettes", "Mesh Silhouettes", "off", "off",
         "Outlines follow the edges of the mesh where these are seen to be edges."},
        {"valley_angle", "Valley Angle", "10", "that of ridges", "Set Ridge Angle."},
    };
    struct {
        const char *key, *label;
        LineKind kind;
    } const colors[] = {
        {"ridge_color", "Ridge Color", LineKind::Ridge},
        {"valley_color", "Valley Color", LineKind::Valley},
        {"demarcation_color", "Demarcation Color", LineKind::DemarcatingCurve},
        {"suggestive_color", "Suggestive Contour Color", LineKind::SuggestiveContour},
        {"apparent_color", "Apparent Ridge Color", LineKind::ApparentRidge},
        {"photic_color", "Photic Extremum Color", LineKind::PhoticExtremum},
        {"crease_color", "Crease Color", LineKind::Crease},
        {"border_color", "Border Color", LineKind::Border}};
    for (const auto& color : colors) {
        const QString value = QColor(describe(color.kind).key_color).name();
        gone.push_back({color.key, color.label, value, value,
                        "Line Color and Contour Color are those of lines."});
    }
    const laplacian_lines::LineStyle style;
    for (const StyleRow& row : laplacian_lines::line_style_table()) {
        const QString value = meshlab_host::textOf(row.get(style), meshlab_host::describe(row, ""));
        if (row.instead) gone.push_back({row.key, row.label, value, value, row.instead});
    }
    return gone;
}

namespace {

const Override style_override = {"drawing_style", "Drawing Style", "Custom",
                                 "The drawing style sets this. Choose Custom to set it here."};
const Override mixture_override = {
    "lines", "Lines", "Laplacian Lines, as Switched",
    "The choice of lines sets this. Choose Laplacian Lines, as Switched, to set it here."};

bool isSwitchOfKind(const std::string& key) {
    return std::any_of(laplacian_lines::line_kinds.begin(), laplacian_lines::line_kinds.end(),
                       [&](const auto& kind) { return key == kind.key; });
}

const ColorRow* colorRow(const std::string& key) {
    for (const ParameterGroup& group : decorationTable())
        for (const ParameterRow& any : group.rows)
            if (const auto* row = std::get_if<ColorRow>(&any); row && key == row->key) return row;
    return nullptr;
}

bool isKeptColor(const std::string& key, const DecorationParameters& chosen) {
    const ColorRow* color = colorRow(key);
    return color && color->kind && keepsColor(*color->kind, chosen);
}

}  // namespace

const Override* overrideOf(const std::string& key) {
    static const std::set<std::string> of_style = {"surface", "tones", "background", "light"};
    if (isSwitchOfKind(key)) return &mixture_override;
    return of_style.count(key) || colorRow(key) ? &style_override : nullptr;
}

bool isOverridden(const std::string& key, const DecorationParameters& chosen) {
    const Override* overriding = overrideOf(key);
    if (overriding == &mixture_override) return mixtureOf(chosen);
    return overriding && chosen.drawing_style != DrawingStyle::Custom && !isKeptColor(key, chosen);
}
