// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

class MeshModel;

namespace meshlab_host {

/// What MeshLab itself draws of a layer in one view.
struct LayerDrawing {
    bool has_faces = false;  ///< filled, and in the depth buffer
    bool culls_back_faces = false;
    double mark_pixels = 0;  ///< diameter of points or width of wires, the larger one; 0: none
};

/// The drawing in the view that is being redrawn: its OpenGL context is current and in the state in
/// which MeshLab calls decorations. Empty if it cannot be known, as in MeshLab 2022 and later.
std::optional<LayerDrawing> layerDrawing(const MeshModel& mesh);

}  // namespace meshlab_host
