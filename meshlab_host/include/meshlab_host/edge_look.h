// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

/// Has MeshLab's views show a layer of edges as thin lines in the colors of its vertices. By itself
/// MeshLab puts a dot on each vertex and draws edges in gray. How a new layer is shown it decides
/// when the filter that made it has ended, so this comes into effect after that. Nothing happens in
/// programs without GL views. GUI thread only.
void showAsLines(const MeshDocument& document, int mesh_id);

}  // namespace meshlab_host
