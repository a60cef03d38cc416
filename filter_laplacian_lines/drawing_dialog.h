// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <optional>

#include "drawing_parameters.h"
#include "meshlab_host/filter_dialog.h"
#include "placed_layers.h"

/// Adds to the dialog of the filter what MeshLab's parameters have not: check marks for views, a
/// button that looks for the file, size and scale before anything is drawn, and what it was last
/// applied with. `defaults` is what the dialog was opened with.
void furnishDrawingDialog(meshlab_host::FilterDialog dialog, const DrawingParameters& defaults,
                          const MeshDocument& document);

/// What a drawing will be, in words, before it is made.
class DrawingOutlook {
public:
    /// Says what a unit is, how large the object is with it, and the scale and paper of the
    /// drawing, or why it cannot be made. Fields of the dialog by their labels. Layers are looked
    /// at anew only when they have changed. Nothing while a filter works on them.
    std::optional<QString> inWords(
        const MeshDocument& document,
        const std::function<std::optional<QString>(const QString& label)>& text_of);

private:
    void look(const MeshDocument& document, bool all_visible);

    std::vector<LayerState> seen_;
    PlacedLayers layers_;
};

/// What the dialog was last applied with, from one session of MeshLab to the next. File, title and
/// unit are the mesh's: another one only has the file's ending from it.

void keepSettings(const DrawingParameters& applied, const QString& mesh);

/// By fields of the dialog; `fresh` is what it has for this mesh by default. Nothing if nothing is
/// kept.
std::vector<DrawingField> keptSettings(const DrawingParameters& fresh, const QString& mesh);

/// The parameter "Views" is a text, which also takes angles; those that have a name are chosen by
/// check marks.

/// The view of MeshLab's window.
constexpr const char* window_view = "window";

/// "window", "front", ...
QStringList viewsWithMarks();

/// Whether a text names a view, "six" all sides.
bool hasView(const QString& text, const QString& view);

/// The text with a view or without it; what else is named there stays in its order.
QString withView(const QString& text, const QString& view, bool is_wanted);
