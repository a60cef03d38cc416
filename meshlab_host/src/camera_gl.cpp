// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/camera.h"

namespace meshlab_host {

CameraMatrices cameraFromGl() {
    CameraMatrices camera;
    // Both OpenGL and Eigen store columns.
    glGetDoublev(GL_MODELVIEW_MATRIX, camera.modelview.data());
    glGetDoublev(GL_PROJECTION_MATRIX, camera.projection.data());
    return camera;
}

}  // namespace meshlab_host
