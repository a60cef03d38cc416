// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class MeshModel;

namespace meshlab_host {

/// What MeshLab itself draws of a layer in one view.
struct LayerDrawing {
    bool has_faces = false;  ///< filled, and in the depth buffer
    bool culls_back_faces = false;
    double mark_pixels = 0;  ///< diameter of points or width of wires, the larger one; 0: none
};

/// The drawing in the view that is being redrawn: its OpenGL context is current and in the state in
/// which MeshLab calls decorations. Where it cannot be known, points of the usual size without
/// faces, so that nothing relies on more than may be there.
LayerDrawing layerDrawing(const MeshModel& mesh);

}  // namespace meshlab_host
