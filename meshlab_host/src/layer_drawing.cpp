// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/layer_drawing.h"

#include <algorithm>

#include "scene.h"

namespace meshlab_host {
namespace {

const LayerDrawing unknown = {false, false, 6};

/// Some of MeshLab's shaders draw faces that leave no depth; their settings stay on until all
/// decorations are drawn.
bool facesLeaveDepth() {
    GLboolean writes_depth = GL_FALSE;
    glGetBooleanv(GL_DEPTH_WRITEMASK, &writes_depth);
    return writes_depth && glIsEnabled(GL_DEPTH_TEST) && !glIsEnabled(GL_BLEND);
}

double largestMark(const MLRenderingData& data, const MLPerViewGLOptions& options) {
    // with attenuation this is the size at the middle of the mesh; what is nearer is larger
    constexpr double most_growth = 2;
    double pixels = 0;
    if (data.isPrimitiveActive(MLRenderingData::PR_POINTS))
        pixels = double(options._perpoint_pointsize) *
                 (options._perpoint_pointattenuation_enabled ? most_growth : 1);
    if (data.isPrimitiveActive(MLRenderingData::PR_WIREFRAME_TRIANGLES) ||
        data.isPrimitiveActive(MLRenderingData::PR_WIREFRAME_EDGES))
        pixels = std::max(pixels, double(options._perwire_wirewidth));
    return pixels;
}

}  // namespace

LayerDrawing layerDrawing(const MeshModel& mesh) {
    MLSceneGLSharedDataContext* scene = sceneOf(mesh);
    auto* context = const_cast<QGLContext*>(QGLContext::currentContext());  // as it is kept there
    if (!scene || !context) return unknown;
    MLRenderingData data;
    MLPerViewGLOptions options;
    scene->getRenderInfoPerMeshView(int(mesh.id()), context, data);
    if (!data.get(options)) return unknown;
    LayerDrawing drawing;
    drawing.has_faces = data.isPrimitiveActive(MLRenderingData::PR_SOLID) && facesLeaveDepth();
    drawing.culls_back_faces = options._back_face_cull;
    drawing.mark_pixels = largestMark(data, options);
    return drawing;
}

}  // namespace meshlab_host
