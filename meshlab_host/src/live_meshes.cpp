// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/live_meshes.h"

#include <algorithm>

#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

std::vector<int> liveMeshIds([[maybe_unused]] const MeshModel& mesh) {
    std::vector<int> ids;
#if MESHLAB_API < 2022
    if (mesh.parent)
        for (const MeshModel* other : mesh.parent->meshList)
            if (other) ids.push_back(other->id());
    std::sort(ids.begin(), ids.end());
#endif
    return ids;
}

}  // namespace meshlab_host
