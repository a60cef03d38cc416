// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/layers.h"

namespace meshlab_host {

std::vector<const MeshModel*> layersOf(const MeshDocument& document) {
    std::vector<const MeshModel*> layers;
#if MESHLAB_API < 2022
    for (const MeshModel* mesh : document.meshList)
        if (mesh) layers.push_back(mesh);
#else
    for (const MeshModel& mesh : document.meshIterator())
        layers.push_back(&mesh);
#endif
    return layers;
}

bool isBusy(const MeshDocument& document) {
    return const_cast<MeshDocument&>(document).isBusy();  // which changes nothing
}

}  // namespace meshlab_host
