// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/live_meshes.h"

#include <algorithm>

#include "scene.h"

namespace meshlab_host {

std::vector<int> liveMeshIds(const MeshModel& mesh) {
    std::vector<int> ids;
    if (MLSceneGLSharedDataContext* scene = sceneOf(mesh))
        for (const MeshModel* layer : layersOf(scene->meshDoc()))
            ids.push_back(int(layer->id()));
    std::sort(ids.begin(), ids.end());
    return ids;
}

}  // namespace meshlab_host
