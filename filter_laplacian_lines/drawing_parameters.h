// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <optional>
#include <vector>

#include "line_drawing/sheet_choices.h"
#include "meshlab_host/current_view.h"
#include "meshlab_host/meshlab_api.h"
#include "meshlab_host/parameters.h"

/// What the user chose for a measured drawing, of line_drawing::sheetOptionTable() what the filter
/// has.
using DrawingParameters = line_drawing::SheetChoices;

/// The number of the unit that a mesh of this size most likely has. Scanners measure in mm what is
/// larger than a bead, photogrammetry and phones in m what is smaller than a house; there is no
/// telling cm and inches.
constexpr int likelyUnit(double diagonal) {
    constexpr int millimetre = 0, metre = 2;
    return diagonal < 10 ? metre : millimetre;
}

inline QString inQt(const std::string& text) {
    return QString::fromStdString(text);
}

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

/// What is to be drawn, views in world coordinates. `window` is the current view of the window.
/// @throws laplacian_lines::Error(InvalidOption) with what is understood, also if the view of the
/// window or the decoration's settings are asked for where there are none.
line_drawing::SheetOptions sheetOptions(const DrawingParameters& chosen,
                                        const std::optional<meshlab_host::CurrentView>& window);
