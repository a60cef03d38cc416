// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <optional>

#include "drawing_parameters.h"
#include "meshlab_host/filter_dialog.h"
#include "placed_layers.h"

/// Adds what MeshLab's parameters lack: check marks for views, a file button, size and scale before
/// drawing, and the last settings. `defaults` are those the dialog opened with.
void furnishDrawingDialog(meshlab_host::FilterDialog dialog, const DrawingParameters& defaults,
                          const MeshDocument& document);

/// Describes a drawing before it is made.
class DrawingOutlook {
public:
    /// Unit, size of the object, scale and paper, or why the drawing cannot be made; nothing while
    /// a filter works on the layers. Fields by their labels. Looks at layers again only after
    /// changes.
    std::optional<QString> inWords(
        const MeshDocument& document,
        const std::function<std::optional<QString>(const QString& label)>& text_of);

private:
    void look(const MeshDocument& document, bool all_visible);

    std::vector<LayerState> seen_;
    PlacedLayers layers_;
};

// What the dialog was last applied with, across sessions of MeshLab. File, title and unit belong to
// the mesh: another one only takes the file's extension over.

void keepSettings(const DrawingParameters& applied, const QString& mesh);

/// By fields of the dialog; `fresh` are the mesh's defaults.
std::vector<DrawingField> keptSettings(const DrawingParameters& fresh, const QString& mesh);

// The parameter "Views" is a text that also takes angles; named views have check marks.

constexpr const char* window_view = "window";

/// "window", "front", ...
QStringList viewsWithMarks();

/// "six" has all sides.
bool hasView(const QString& text, const QString& view);

/// Adds or removes a view; all else in the text stays in order.
QString withView(const QString& text, const QString& view, bool is_wanted);
