// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QStringList>
#include <optional>
#include <vector>

#include "laplacian_lines/line_mixture.h"
#include "laplacian_lines/line_style.h"
#include "laplacian_lines/option_table.h"
#include "line_drawing/sheet_options.h"
#include "line_renderer/line_appearance.h"
#include "meshlab_host/drawn_style.h"
#include "meshlab_host/meshlab_api.h"

/// Makes names unique among MeshLab's plugins.
inline const QString kDecorationPrefix = "MeshLab::Decoration::LaplacianLines_";

/// All but Custom override color and surface, and the light unless it suits them.
enum class DrawingStyle { Custom, Publication, Archaeology };

/// Value of `mixture` with which kinds are ticked one by one.
constexpr int kAsTicked = 0;

/// All but the first have paper around the surface.
enum class SurfaceLook { AsMeshLabDrawsIt, Paper, Toon, OnPaper };

/// What is shown once nothing moves.
enum class AtRest { PrintedDrawing, LiveLines };

/// From 1 on, lights turn with the camera: eight around the picture, clockwise.
constexpr int kAtTheEye = 0, kFromTheUpperLeft = 1;

/// Width of a class of lines on paper, in widths of inner lines; also that of live lines.
constexpr double pen(line_drawing::LineClass line_class) {
    constexpr line_drawing::Pens pens = line_drawing::pens_of(line_drawing::Weights::Illustrator);
    return pens[std::size_t(line_class)] / pens[std::size_t(line_drawing::LineClass::Inner)];
}

static_assert(pen(line_drawing::LineClass::Outline) ==
              describe(laplacian_lines::LineKind::Contour).width);

/// MeshLab's decoration parameters, which all views share.
struct DecorationParameters {
    DrawingStyle drawing_style = DrawingStyle::Custom;
    int mixture = kAsTicked;  ///< of laplacian_lines::kLineMixtures, counted from 1
    laplacian_lines::LineStyle style;
    double line_width = line_renderer::kUsualLineWidth;
    double outline_width = describe(laplacian_lines::LineKind::Contour).width;  ///< in line widths
    QColor line_color = Qt::black;
    line_renderer::LineAppearance appearance;  ///< its looks follow from the above
    AtRest at_rest = AtRest::PrintedDrawing;
    SurfaceLook surface = SurfaceLook::AsMeshLabDrawsIt;
    int light = kAtTheEye;
    bool show_statistics = false;
};

/// In MeshLab's order.
const std::vector<laplacian_lines::OptionRow<DecorationParameters>>& decoration_table();

void list_decoration_parameters(RichParameterList& list);

/// Azimuth of a light that turns with the camera, see meshlab_host::towards_light(); else none.
std::optional<double> light_azimuth(const DecorationParameters& parameters);

/// Values out of range are replaced by the last valid ones.
struct ValidParameters {
    DecorationParameters chosen;  ///< with drawing style and mixture applied
    DecorationParameters as_set;
    QStringList refused;  ///< for each invalid value, what is wrong and what it stays
};
ValidParameters read_valid_parameters(const RichParameterList& list,
                                      const DecorationParameters& last_time = {});

/// The part that filters can use.
meshlab_host::DrawnStyle drawn_style_of(const DecorationParameters& parameters);

/// Removes settings that MeshLab has kept for parameters of another version. Returns a message,
/// empty if there were none.
QString forget_other_settings();
