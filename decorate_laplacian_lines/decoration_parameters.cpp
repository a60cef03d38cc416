// SPDX-License-Identifier: GPL-3.0-or-later
#include "decoration_parameters.h"

#include "laplacian_lines/option_table.h"
#include "meshlab_host/parameters.h"

namespace {

QString key(const char* name) {
    return QString("MeshLab::Decoration::LaplacianLines_") + name;
}

constexpr const char* color_name = "line_color";
constexpr const char* contour_color_name = "contour_color";
constexpr const char* hidden_name = "hidden_lines";
constexpr const char* width_name = "line_width";
constexpr const char* contour_name = "contour_width_factor";
constexpr const char* surface_name = "surface";
constexpr const char* paper_name = "paper_color";
constexpr const char* shade_name = "shade_color";
constexpr const char* tones_name = "tones";
constexpr const char* statistics_name = "show_statistics";

void listSurfaceParameters(RichParameterList& list) {
    const SurfaceAppearance look;
    list.addParam(RichEnum(key(surface_name), look.style, {"As MeshLab Draws It", "Paper", "Toon"},
                           "Surface",
                           "What is seen of the surface. Paper: nothing but lines on one plain "
                           "color. Toon: a few flat tones, darker where the surface turns away. "
                           "Both cover MeshLab's own drawing of the layer."));
    list.addParam(RichColor(key(paper_name), look.paper, "Paper Color",
                            "Color of the paper, and of the lightest tone."));
    list.addParam(
        RichColor(key(shade_name), look.shade, "Shade Color", "Color of the darkest tone (Toon)."));
    list.addParam(RichInt(key(tones_name), look.tones, "Tones",
                          "Number of tones from shade to paper, 2 to 8 (Toon)."));
}

SurfaceAppearance readSurfaceAppearance(const RichParameterList& list) {
    SurfaceAppearance look;
    look.style = SurfaceAppearance::Style(meshlab_host::readClamped(
        key(surface_name), look.style, SurfaceAppearance::AsMeshLabDrawsIt, SurfaceAppearance::Toon,
        list));
    look.paper = meshlab_host::readColor(key(paper_name), look.paper, list);
    look.shade = meshlab_host::readColor(key(shade_name), look.shade, list);
    look.tones = int(meshlab_host::readClamped(key(tones_name), look.tones, 2,
                                               SurfaceAppearance::most_tones, list));
    return look;
}

}  // namespace

void listDecorationParameters(RichParameterList& list) {
    const LineAppearance look;
    list.addParam(
        RichColor(key(color_name), look.color, "Line Color", "Color of Laplacian lines."));
    list.addParam(RichColor(key(contour_color_name), look.contour_color, "Contour Color",
                            "Color of occluding contours, which go around the form."));
    list.addParam(RichFloat(key(width_name), float(look.width), "Line Width",
                            "Width in pixels of a Laplacian line at its strongest; lines taper "
                            "where they fade out."));
    list.addParam(RichFloat(key(contour_name), float(look.contour_factor), "Contour Width Factor",
                            "Width of occluding contours, in widths of Laplacian lines."));
    list.addParam(RichEnum(key(hidden_name), int(look.hidden), {"Left Out", "Faint", "Dashed"},
                           "Hidden Lines",
                           "What is drawn of lines that the surface hides: nothing, faint lines, "
                           "or dashes."));
    listSurfaceParameters(list);
    meshlab_host::addParameters(laplacian_lines::line_style_table(), laplacian_lines::LineStyle(),
                                0, key(""), list);
    list.addParam(RichBool(key(statistics_name), DecorationParameters().show_statistics,
                           "Show Statistics",
                           "Show the number of lines and the time they take in the view."));
}

DecorationParameters readDecorationParameters(const RichParameterList& list) {
    DecorationParameters result;
    LineAppearance& look = result.appearance;
    look.color = meshlab_host::readColor(key(color_name), look.color, list);
    look.contour_color = meshlab_host::readColor(key(contour_color_name), look.contour_color, list);
    look.hidden = HiddenLines(meshlab_host::readClamped(key(hidden_name), int(look.hidden),
                                                        int(HiddenLines::LeftOut),
                                                        int(HiddenLines::Dashed), list));
    look.width = meshlab_host::readClamped(key(width_name), look.width, 0.1, 64, list);
    look.contour_factor =
        meshlab_host::readClamped(key(contour_name), look.contour_factor, 0, 16, list);
    result.surface = readSurfaceAppearance(list);
    result.show_statistics =
        meshlab_host::readSwitch(key(statistics_name), result.show_statistics, list);
    result.style = meshlab_host::readOptions(laplacian_lines::line_style_table(), key(""), list);
    // contours without width must not push other lines aside
    if (look.contour_factor == 0) result.style.contours = false;
    return result;
}
