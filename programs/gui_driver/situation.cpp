// SPDX-License-Identifier: GPL-3.0-or-later
#include "situation.h"

#include <QApplication>
#include <QCheckBox>
#include <algorithm>

#include "gui.h"
#include "meshlab_host/documents.h"
#include "scene.h"

namespace driver {
namespace {

/// The scene that shares objects with the view; it lives as long.
MLSceneGLSharedDataContext* sceneOfView() {
    QGLWidget* shown = view();
    for (QWidget* widget : QApplication::allWidgets())
        if (auto* scene = qobject_cast<MLSceneGLSharedDataContext*>(widget))
            if (shown && QGLContext::areSharing(scene->context(), shown->context())) return scene;
    return nullptr;
}

bool isPreviewOffered() {
    const QWidgetList widgets = QApplication::allWidgets();
    return std::any_of(widgets.begin(), widgets.end(), [](const QWidget* widget) {
        const auto* box = qobject_cast<const QCheckBox*>(widget);
        return box && box->isVisible() && box->text() == "Preview";
    });
}

}  // namespace

Situation presentSituation() {
    Situation result;
    result.documents = documentWindows().size();
    result.views = visibleViews().size();
    if (MLSceneGLSharedDataContext* scene = sceneOfView()) {
        result.layers = meshlab_host::layersOf(scene->meshDoc());
        result.current = scene->meshDoc().mm();
    }
    const QAction* decoration = findAction("Laplacian Lines");
    result.has_lines = result.current && decoration && decoration->isChecked();
    result.has_preview = isPreviewOffered();
    return result;
}

void makeLayerCurrent(const MeshModel* layer) {
    if (MLSceneGLSharedDataContext* scene = sceneOfView())
        scene->meshDoc().setCurrentMesh(layer->id());
}

}  // namespace driver
