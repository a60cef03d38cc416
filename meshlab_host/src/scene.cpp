// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene.h"

#include <QApplication>
#include <QPointer>
#include <algorithm>

namespace meshlab_host {
namespace {

bool holds(MLSceneGLSharedDataContext& scene, const MeshModel& mesh) {
    const std::vector<const MeshModel*> layers = layersOf(scene.meshDoc());
    return std::find(layers.begin(), layers.end(), &mesh) != layers.end();
}

}  // namespace

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

MLSceneGLSharedDataContext* sceneOf(const MeshModel& mesh) {
    // a widget that is never shown and has no parent to be found by
    static QPointer<MLSceneGLSharedDataContext> last;
    if (last && holds(*last, mesh)) return last;
    for (QWidget* widget : QApplication::allWidgets()) {
        auto* scene = qobject_cast<MLSceneGLSharedDataContext*>(widget);
        if (scene && holds(*scene, mesh)) return last = scene;
    }
    return nullptr;
}

}  // namespace meshlab_host
