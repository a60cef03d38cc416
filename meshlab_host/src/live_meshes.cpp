// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/live_meshes.h"

#include <algorithm>

#include "meshlab_host/layers.h"
#include "scene.h"

namespace meshlab_host {

namespace {

std::vector<int> idsOf(const MeshDocument& document) {
    std::vector<int> ids;
    for (const MeshModel* layer : layersOf(document))
        ids.push_back(int(layer->id()));
    std::sort(ids.begin(), ids.end());
    return ids;
}

}  // namespace

std::vector<int> liveMeshIds(const MeshModel& mesh) {
    MLSceneGLSharedDataContext* scene = sceneOf(mesh);
    return scene ? idsOf(scene->meshDoc()) : std::vector<int>();
}

QObject* documentOf(const MeshModel& mesh) {
    MLSceneGLSharedDataContext* scene = sceneOf(mesh);
    return scene ? &scene->meshDoc() : nullptr;
}

void whenMeshesChange(QObject* document, QObject* receiver,
                      const std::function<void(const std::vector<int>&)>& changed) {
    const auto* sender = static_cast<const MeshDocument*>(document);
    QObject::connect(sender, &MeshDocument::meshSetChanged, receiver,
                     [=] { changed(idsOf(*sender)); });
    QObject::connect(document, &QObject::destroyed, receiver, [=] { changed({}); });
}

}  // namespace meshlab_host
