// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/layer_drawing.h"

#include <QApplication>
#include <QTimer>
#include <algorithm>

#include "meshlab_host/documents.h"

namespace meshlab_host {

namespace {

/// With attenuation, points have their size at the mesh's middle; nearer ones are up to so many
/// times as large.
constexpr double kMostGrowth = 2;

/// As if nothing were sure to be in the depth buffer: no faces, and points of 3 pixels, as usual.
const LayerDrawing kUnknown = {false, false, 3 * kMostGrowth};

/// Some of MeshLab's shaders draw faces without depth; their settings last until decorations are
/// drawn.
bool faces_leave_depth() {
    GLboolean writes_depth = GL_FALSE;
    glGetBooleanv(GL_DEPTH_WRITEMASK, &writes_depth);
    return writes_depth && glIsEnabled(GL_DEPTH_TEST) && !glIsEnabled(GL_BLEND);
}

double largest_mark(const MLRenderingData& data, const MLPerViewGLOptions& options) {
    double pixels = 0;
    if (data.isPrimitiveActive(MLRenderingData::PR_POINTS))
        pixels = double(options._perpoint_pointsize) *
                 (options._perpoint_pointattenuation_enabled ? kMostGrowth : 1);
    if (data.isPrimitiveActive(MLRenderingData::PR_WIREFRAME_TRIANGLES) ||
        data.isPrimitiveActive(MLRenderingData::PR_WIREFRAME_EDGES))
        pixels = std::max(pixels, double(options._perwire_wirewidth));
    return pixels;
}

}  // namespace

LayerDrawing layer_drawing(const MeshModel& mesh) {
    MLSceneGLSharedDataContext* scene = scene_of(mesh);
    auto* context = const_cast<QGLContext*>(QGLContext::currentContext());  // as it is kept there
    if (!scene || !context) return kUnknown;
    MLRenderingData data;
    MLPerViewGLOptions options;
    scene->getRenderInfoPerMeshView(int(mesh.id()), context, data);
    if (!data.get(options)) return kUnknown;
    LayerDrawing drawing;
    drawing.has_faces = data.isPrimitiveActive(MLRenderingData::PR_SOLID) && faces_leave_depth();
    drawing.culls_back_faces = options._back_face_cull;
    drawing.mark_pixels = largest_mark(data, options);
    return drawing;
}

namespace {

using Attributes = MLRenderingData::ATT_NAMES;

MLRenderingData lines_only(MeshModel& mesh) {
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

/// Updates MeshLab's toolbar, which shows how the current layer is drawn, and its views.
void refresh_window() {
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (widget->inherits("MainWindow"))
            QMetaObject::invokeMethod(widget, "updateLayerDialog", Qt::DirectConnection);
    for (QWidget* widget : QApplication::allWidgets())
        if (widget->inherits("GLArea")) widget->update();
}

}  // namespace

void show_as_lines(const MeshDocument& document, int mesh_id) {
    MLSceneGLSharedDataContext* scene = scene_of(document);
    if (!scene) return;
    // A timer of the scene: if that is closed before, nothing happens.
    QTimer::singleShot(0, scene, [scene, mesh_id] {
        MeshModel* mesh = scene->meshDoc().getMesh(mesh_id);
        if (!mesh || mesh->cm.fn > 0 || mesh->cm.en == 0) return;
        scene->setRenderingDataPerAllMeshViews(mesh_id, lines_only(*mesh));
        scene->manageBuffers(mesh_id);
        refresh_window();
    });
}

void keep_unmodified(const MeshDocument& document) {
    MLSceneGLSharedDataContext* scene = scene_of(document);
    const MeshModel* current = const_cast<MeshDocument&>(document).mm();  // which changes nothing
    if (!scene || !current || current->meshModified()) return;
    QTimer::singleShot(0, scene, [scene, id = current->id()] {
        if (MeshModel* mesh = scene->meshDoc().getMesh(id)) mesh->setMeshModified(false);
        refresh_window();
    });
}

}  // namespace meshlab_host
