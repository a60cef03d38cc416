// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <meshlab_host/meshlab_api.h>

#include <vector>

namespace driver {

struct Situation {
    int documents = 0;
    int views = 0;                         ///< of the current document
    std::vector<const MeshModel*> layers;  ///< of the current document
    MeshModel* current = nullptr;          ///< layer, null if there is none
    bool has_lines = false;                ///< the decoration of the current layer is on
    bool has_preview = false;              ///< a dialog is open that offers one
};
Situation presentSituation();

void makeLayerCurrent(const MeshModel* layer);  ///< one of the present layers

}  // namespace driver
