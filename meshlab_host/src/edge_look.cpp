// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/edge_look.h"

#include <QApplication>
#include <QTimer>

#include "scene.h"

namespace meshlab_host {
namespace {

using Attributes = MLRenderingData::ATT_NAMES;

MLRenderingData linesOnly(MeshModel& mesh) {
    MLRenderingData look;
    MLPoliciesStandAloneFunctions::suggestedDefaultPerViewRenderingData(&mesh, look);
    look.set(MLRenderingData::PR_POINTS, false);
    MLRenderingData::RendAtts attributes;
    attributes[Attributes::ATT_VERTPOSITION] = true;
    attributes[Attributes::ATT_VERTCOLOR] = true;
    look.set(MLRenderingData::PR_WIREFRAME_EDGES, attributes);
    MLPerViewGLOptions options;
    look.get(options);
    options._peredge_wire_enabled = true;
    options._perwire_fixed_color_enabled = false;
    options._perwire_mesh_color_enabled = false;
    options._perwire_noshading = true;
    look.set(options);
    return look;
}

/// MeshLab's toolbar shows how the current layer is drawn; it looks when its window is told to.
void refreshWindow() {
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (widget->inherits("MainWindow"))
            QMetaObject::invokeMethod(widget, "updateLayerDialog", Qt::DirectConnection);
    for (QWidget* widget : QApplication::allWidgets())
        if (widget->inherits("GLArea")) widget->update();
}

}  // namespace

void showAsLines(const MeshDocument& document, int mesh_id) {
    MLSceneGLSharedDataContext* scene = sceneOf(document);
    if (!scene) return;
    // as the scene's own timer: it goes with its document
    QTimer::singleShot(0, scene, [scene, mesh_id] {
        MeshModel* mesh = scene->meshDoc().getMesh(mesh_id);
        if (!mesh || mesh->cm.fn > 0 || mesh->cm.en == 0) return;
        scene->setRenderingDataPerAllMeshViews(mesh_id, linesOnly(*mesh));
        scene->manageBuffers(mesh_id);
        refreshWindow();
    });
}

}  // namespace meshlab_host
