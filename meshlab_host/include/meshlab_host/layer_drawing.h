// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_host/meshlab_api.h"

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

/// Has MeshLab's views show a layer of edges as thin lines in the colors of its vertices. By itself
/// MeshLab puts a dot on each vertex and draws edges in gray. How a new layer is shown it decides
/// when the filter that made it has ended, so this comes into effect after that. Nothing happens in
/// programs without GL views. GUI thread only.
void showAsLines(const MeshDocument& document, int mesh_id);

}  // namespace meshlab_host
