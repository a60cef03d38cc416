// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/documents.h"

#include <QTimer>
#include <algorithm>

#include "meshlab_host/scene.h"

namespace meshlab_host {

namespace {

std::vector<int> idsOf(const MeshDocument& document, bool only_shown = false) {
    std::vector<int> ids;
    for (const MeshModel* layer : layersOf(document))
        if (!only_shown || layer->isVisible()) ids.push_back(int(layer->id()));
    std::sort(ids.begin(), ids.end());
    return ids;
}

/// MeshLab 2020.09 has a pointer to its history.
[[maybe_unused]] FilterScript& itself(FilterScript* script) {
    return *script;
}
[[maybe_unused]] FilterScript& itself(FilterScript& script) {
    return script;
}

}  // namespace

std::vector<int> liveMeshIds(const MeshModel& mesh) {
    MLSceneGLSharedDataContext* scene = sceneOf(mesh);
    return scene ? idsOf(scene->meshDoc()) : std::vector<int>();
}

std::vector<int> shownMeshIds(const MeshModel& mesh) {
    MLSceneGLSharedDataContext* scene = sceneOf(mesh);
    return scene ? idsOf(scene->meshDoc(), true) : std::vector<int>();
}

MeshDocument* documentOf(const MeshModel& mesh) {
    MLSceneGLSharedDataContext* scene = sceneOf(mesh);
    return scene ? &scene->meshDoc() : nullptr;
}

void whenMeshesChange(const MeshDocument* document, QObject* receiver,
                      const std::function<void(const std::vector<int>&)>& changed) {
    QObject::connect(document, &MeshDocument::meshSetChanged, receiver,
                     [=] { changed(idsOf(*document)); });
    QObject::connect(document, &QObject::destroyed, receiver, [=] { changed({}); });
}

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

GLLogStream* documentLog(const MeshModel& mesh) {
    MLSceneGLSharedDataContext* scene = sceneOf(mesh);
    return scene ? &scene->meshDoc().Log : nullptr;
}

void writeOnView(GLLogStream& log, const QString& title, const QString& mesh, const QString& text) {
#if MESHLAB_API < 2022
    log.RealTimeLog(title, mesh, text);
#else
    log.realTimeLog(title, mesh, text);
#endif
}

void recordAs(const QString& filter, const RichParameterList& parameters, MeshDocument& document) {
    QTimer::singleShot(0, &document,
                       [filter, parameters, &document] {  // some MeshLabs record afterwards
                           FilterScript& history = itself(document.filterHistory);
                           if (!history.isEmpty() && history.last().first == filter)
                               history.last().second = parameters;
                       });
}

}  // namespace meshlab_host
