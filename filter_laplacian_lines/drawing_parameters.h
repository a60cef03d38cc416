// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <optional>
#include <vector>

#include "line_drawing/sheet_options.h"
#include "meshlab_host/meshlab_api.h"
#include "meshlab_host/parameters.h"

/// Which lines: the usual ones, or lines and light as the decoration has drawn them last.
constexpr int default_settings = 0, settings_of_decoration = 1;

/// What the user chose for a measured drawing, as in the dialog.
struct DrawingParameters {
    QString file = "drawing.svg";
    QString views = "front";
    QString scale = "fit";
    QString sections;
    QString title;
    int paper = 1;  ///< of paperNames(), and one more: as large as the drawing
    int unit = 0;   ///< of mm, cm, m, in
    line_drawing::UpAxis up = line_drawing::UpAxis::Y;
    line_drawing::Arrangement arrangement = line_drawing::Arrangement::FirstAngle;
    line_drawing::StrokeStyle strokes = line_drawing::StrokeStyle::Tapered;
    line_drawing::WallStyle wall = line_drawing::WallStyle::Hatched;
    line_drawing::Weights weights = line_drawing::Weights::Illustrator;
    bool has_furniture = true;
    line_drawing::HiddenLines hidden = line_drawing::HiddenLines::LeftOut;
    bool is_of_all_layers = false;    ///< the visible ones
    int settings = default_settings;  ///< from 2 on, mixtures of lines
};

/// Labels of fields that the dialog adds something to.
namespace drawing_labels {
inline const QString file = "File", views = "Views";
}

/// What files a drawing may be in, for dialogs that look for one.
inline const QString drawing_files = "Drawings (*.svg *.pdf *.dxf *.png)";

/// Where the dialog starts: with a file beside that of the mesh, and, if there is a window, at its
/// view and with the unit that the mesh most likely has. Scripts have the same everywhere.
DrawingParameters drawingDefaults(const MeshModel* mesh, bool has_window);

void listDrawingParameters(const DrawingParameters& defaults, RichParameterList& list);

/// What the dialog shows of a parameter.
struct DrawingField {
    QString key, label, text;
};
std::vector<DrawingField> fieldsOf(const DrawingParameters& parameters);

/// Of fields of the dialog, found by their labels.
/// @throws laplacian_lines::Error(InvalidOption) that names a field which is out of range.
DrawingParameters drawingParametersIn(
    const std::function<std::optional<QString>(const QString& label)>& text_of);

/// The parameters that are switches or choices; texts are not among them.
std::vector<meshlab_host::ParameterDescription> describeDrawingParameters();

/// @throws laplacian_lines::Error(InvalidOption) that names a parameter which is out of range.
DrawingParameters readDrawingParameters(const RichParameterList& list);
