// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/edge_look.h"

#if MESHLAB_API < 2022
#include <common/ml_shared_data_context.h>
#else
#include <common/ml_shared_data_context/ml_scene_gl_shared_data_context.h>
#endif

#include <QApplication>
#include <QTimer>

namespace meshlab_host {
namespace {

using Context = MLSceneGLSharedDataContext;
using Attributes = MLRenderingData::ATT_NAMES;

/// What the views of a document share; null where there are none.
Context* sharedContext(const MeshDocument& document) {
    if (!qobject_cast<QApplication*>(QCoreApplication::instance())) return nullptr;
    for (QWidget* widget : QApplication::allWidgets())
        if (auto* context = qobject_cast<Context*>(widget))
            if (&context->meshDoc() == &document) return context;
    return nullptr;
}

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
    Context* context = sharedContext(document);
    if (!context) return;
    // as the context's own timer: it goes with its document
    QTimer::singleShot(0, context, [context, mesh_id] {
        MeshModel* mesh = context->meshDoc().getMesh(mesh_id);
        if (!mesh || mesh->cm.fn > 0 || mesh->cm.en == 0) return;
        context->setRenderingDataPerAllMeshViews(mesh_id, linesOnly(*mesh));
        context->manageBuffers(mesh_id);
        refreshWindow();
    });
}

}  // namespace meshlab_host
