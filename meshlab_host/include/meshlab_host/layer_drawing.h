// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

struct LayerDrawing {
    bool has_faces = false;  ///< filled, and in the depth buffer
    bool culls_back_faces = false;
    double mark_pixels = 0;  ///< diameter of points or width of wires, the larger one; 0: none
};

/// How MeshLab draws a layer in the view being redrawn, called from a decoration. If unknown, as
/// points of the default size without faces, the safe assumption.
LayerDrawing layer_drawing(const MeshModel& mesh);

/// Shows a layer of edges as thin lines in vertex colors; MeshLab would put dots on vertices and
/// draw edges gray. Takes effect after the filter that made the layer, when MeshLab decides how to
/// show it. Does nothing without GL views. GUI thread only.
void show_as_lines(const MeshDocument& document, int mesh_id);

/// For filters that only write files: after a filter MeshLab marks the current layer as modified,
/// and asks whether to save it. Takes effect after the filter. GUI thread only.
void keep_unmodified(const MeshDocument& document);

}  // namespace meshlab_host
