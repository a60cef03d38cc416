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

/// Looks chosen by one parameter, whatever color, surface and light say.
enum class DrawingStyle { Custom, Publication, Archaeology };

/// The ticks of kinds count; otherwise a mixture does.
constexpr int kAsTicked = 0;

/// All but the first have paper around the surface.
enum class SurfaceLook { AsMeshLabDrawsIt, Paper, Toon, OnPaper };

/// What is shown once nothing moves.
enum class AtRest { PrintedDrawing, LiveLines };

/// From 1 on, lights turn with the camera: eight around the picture, clockwise.
constexpr int kAtTheEye = 0, kFromTheUpperLeft = 1;

/// Of a class of printed lines, in widths of lines inside: the same while the view turns.
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
    line_renderer::LineAppearance appearance;  ///< its looks are made of the above
    AtRest at_rest = AtRest::PrintedDrawing;
    SurfaceLook surface = SurfaceLook::AsMeshLabDrawsIt;
    int light = kAtTheEye;
    bool show_statistics = false;
};

/// In MeshLab's order.
const std::vector<laplacian_lines::OptionRow<DecorationParameters>>& decoration_table();

void list_decoration_parameters(RichParameterList& list);

/// Of the light that turns with the camera, if it does, as meshlab_host::towards_light() takes it.
std::optional<double> light_azimuth(const DecorationParameters& parameters);

/// Values out of range are those of the last time.
struct ValidParameters {
    DecorationParameters chosen;  ///< with drawing style and mixture applied
    DecorationParameters as_set;
    QStringList refused;  ///< what is wrong, a sentence a value
};
ValidParameters read_valid_parameters(const RichParameterList& list,
                                      const DecorationParameters& last_time = {});

/// The part that filters can follow.
meshlab_host::DrawnStyle drawn_style_of(const DecorationParameters& parameters);
