// SPDX-License-Identifier: GPL-3.0-or-later
#include "decoration_parameters.h"

#include <QSettings>
#include <algorithm>

#include "laplacian_lines/error.h"
#include "laplacian_lines/option_rows.h"
#include "line_drawing/sheet_choices.h"
#include "meshlab_host/parameters.h"

namespace {

using namespace laplacian_lines::option_rows;
using laplacian_lines::LineKind;
using laplacian_lines::LineStyle;
using Parameters = DecorationParameters;
constexpr auto kStyle = &Parameters::style;

using Row = laplacian_lines::OptionRow<Parameters>;

void read(const Row& row, const RichParameterList& list, const DecorationParameters& last_time,
          ValidParameters& result) {
    try {
        meshlab_host::read_parameter(row, result.as_set, list, kDecorationPrefix);
    } catch (const laplacian_lines::Error& error) {
        const double value = row.get(last_time);
        row.set(result.as_set, value);
        result.refused +=
            QString("%1 Until then it stays %2.")
                .arg(QString::fromUtf8(error.what()), meshlab_host::text_of(value, row));
    }
}

Row line_color() {
    return {{"line_color",
             "Line Color",
             "Of all lines but those that Lines tells apart by their colors.",
             laplacian_lines::OptionKind::Color,
             0,
             0xffffff,
             {}},
            [](const Parameters& p) { return double(p.line_color.rgb() & 0xffffff); },
            [](Parameters& p, double value) { p.line_color = QColor(QRgb(value)); }};
}

/// Null if the kinds are ticked one by one.
const laplacian_lines::LineMixture* mixture_of(const DecorationParameters& parameters) {
    if (parameters.mixture == kAsTicked) return nullptr;
    return &laplacian_lines::kLineMixtures.at(std::size_t(parameters.mixture - 1));
}

/// Kinds drawn in colors of their own; in black drawing styles only for the mixture of all kinds.
laplacian_lines::LineKindSet colored_kinds(const DecorationParameters& parameters) {
    const laplacian_lines::LineMixture* mixture = mixture_of(parameters);
    if (!mixture) return {};
    const bool is_in_black = parameters.drawing_style != DrawingStyle::Custom;
    const bool colors_all = mixture->colored == laplacian_lines::kinds_with_key_color();
    return is_in_black && !colors_all ? laplacian_lines::LineKindSet() : mixture->colored;
}

line_renderer::LineLooks looks_of(const DecorationParameters& parameters) {
    const laplacian_lines::LineKindSet colored = colored_kinds(parameters);
    constexpr double share_within =
        pen(line_drawing::LineClass::Contour) / pen(line_drawing::LineClass::Outline);
    line_renderer::LineLooks looks;
    std::transform(
        laplacian_lines::kLineKinds.begin(), laplacian_lines::kLineKinds.end(), looks.begin(),
        [&](const laplacian_lines::LineKindDescription& kind) {
            return line_renderer::LineLook{
                colored[kind.kind] ? QColor(kind.key_color) : parameters.line_color,
                parameters.line_width * (kind.bounds_form ? parameters.outline_width : 1),
                kind.bounds_form ? share_within : 1};
        });
    return looks;
}

DecorationParameters in_effect(DecorationParameters parameters) {
    if (const auto* mixture = mixture_of(parameters)) parameters.style.shows = mixture->kinds;
    if (parameters.drawing_style != DrawingStyle::Custom) {
        parameters.line_color = Qt::black;
        parameters.surface = SurfaceLook::Paper;
    }
    if (parameters.drawing_style == DrawingStyle::Publication) parameters.light = kAtTheEye;
    if (parameters.drawing_style == DrawingStyle::Archaeology)
        parameters.light = std::max(parameters.light, kFromTheUpperLeft);
    parameters.appearance.looks = looks_of(parameters);
    return parameters;
}

}  // namespace

const std::vector<Row>& decoration_table() {
    static const std::vector<Row> table = {
        choice<&Parameters::drawing_style>(
            "drawing_style", "Drawing Style",
            {"Custom", "Publication (Black on White)", "Archaeology (Side Light)"},
            "Publication: black lines on white paper that fills the view, with the light at the "
            "eye. Archaeology: the same with the light from the upper left, or from where Light "
            "has it. Line Color and Surface count in the style Custom only."),
        choice<&Parameters::mixture>(
            "lines", "Lines", line_drawing::settings_names({"As Ticked Below"}),
            "The kinds ticked below, or one of the kinds of other papers with the outlines, "
            "whatever is ticked. All Kinds, in Colors: all at once, each in a color of its own."),
        real<kStyle, &LineStyle::detail>(
            "detail", "Detail", 0, 100,
            "0 to 100: more or fewer lines of all kinds; 50 is the usual. At Rest they are those "
            "of finer or coarser forms as well."),
        real<&Parameters::line_width>("line_width", "Line Width", 0.1, 64,
                                      "In pixels, where a line is strongest; it tapers where it "
                                      "fades out."),
        real<&Parameters::outline_width>(
            "contour_width_factor", "Outline Width", 0.1, 16,
            "Of outlines, in widths of the lines inside. Contours before a "
            "farther part of the surface have 0.7 of it."),
        line_color(),
        choice<&Parameters::appearance, &line_renderer::LineAppearance::hidden>(
            "hidden_lines", "Hidden Lines", {"Not Drawn", "Faint", "Dashed"},
            "Those behind the surface."),
        choice<&Parameters::at_rest>(
            "at_rest", "At Rest", {"Printed Drawing", "Live Lines"},
            "Once the view has not changed for a moment. Printed Drawing: as the filter Export "
            "Laplacian Lines Drawing draws it, with whole strokes and a pen of 0.25 mm as wide as "
            "Line Width. Where a visible layer has no lines, or is points alone, they stay live."),
        kind_switch<LineKind::Contour, kStyle, &LineStyle::shows>(),
        kind_switch<LineKind::Laplacian, kStyle, &LineStyle::shows>(),
        kind_switch<LineKind::Ridge, kStyle, &LineStyle::shows>(),
        kind_switch<LineKind::Crease, kStyle, &LineStyle::shows>(),
        kind_switch<LineKind::Border, kStyle, &LineStyle::shows>(),
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
        real<kStyle, &LineStyle::gradient_threshold>(
            "gradient_threshold", "Gradient Threshold t", 0, 1e6,
            "Least change of the shading across a line: its gradient times the diagonal of the "
            "bounding box, without a unit. Larger leaves out lines on gentle forms."),
        real<kStyle, &LineStyle::strength_threshold>(
            "strength_threshold", "Strength Threshold tau", 0, 1e6,
            "Least strength of a line: its gradient summed along its length, without a unit. "
            "Larger leaves out short and weak lines."),
    };
    return table;
}

void list_decoration_parameters(RichParameterList& list) {
    for (const Row& row : decoration_table())
        meshlab_host::add_parameter(row, row.value(DecorationParameters()), list, 0,
                                    kDecorationPrefix);
}

std::optional<double> light_azimuth(const DecorationParameters& parameters) {
    if (parameters.light == kAtTheEye) return std::nullopt;
    return 315 + 45 * (parameters.light - kFromTheUpperLeft);
}

ValidParameters read_valid_parameters(const RichParameterList& list,
                                      const DecorationParameters& last_time) {
    ValidParameters result;
    for (const Row& row : decoration_table())
        read(row, list, last_time, result);
    result.chosen = in_effect(result.as_set);
    return result;
}

meshlab_host::DrawnStyle drawn_style_of(const DecorationParameters& parameters) {
    meshlab_host::DrawnStyle drawn;
    drawn.style = parameters.style;
    drawn.light_azimuth = light_azimuth(parameters);
    drawn.shows_hidden = parameters.appearance.hidden != line_renderer::HiddenLines::LeftOut;
    std::transform(parameters.appearance.looks.begin(), parameters.appearance.looks.end(),
                   drawn.colors.begin(),
                   [](const line_renderer::LineLook& look) { return look.color.rgb(); });
    return drawn;
}

QString forget_other_settings() {
    RichParameterList known;
    list_decoration_parameters(known);
    QSettings settings;
    QStringList names;
    for (const QString& key : settings.allKeys()) {
        if (!key.startsWith(kDecorationPrefix) || known.hasParameter(key)) continue;
        names << key.mid(kDecorationPrefix.size());
        settings.remove(key);
    }
    return names.isEmpty() ? QString()
                           : "Settings of another version are ignored: " + names.join(", ") + '.';
}
