// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/documents.h"

#include <QApplication>
#include <QPointer>
#include <QTimer>
#include <algorithm>

namespace meshlab_host {
namespace {

/// Closing a project can destroy a document before its scene, which keeps a reference, so each
/// document is watched from when its scene is first seen.
class WatchedDocuments {
public:
    /// Null if it is gone.
    const MeshDocument* of(MLSceneGLSharedDataContext* scene) {
        entries_.erase(std::remove_if(entries_.begin(), entries_.end(),
                                      [](const Entry& entry) { return entry.scene.isNull(); }),
                       entries_.end());
        for (const Entry& entry : entries_)
            if (entry.scene == scene) return entry.document;
        entries_.push_back({scene, &scene->meshDoc()});
        return entries_.back().document;
    }

private:
    struct Entry {
        QPointer<MLSceneGLSharedDataContext> scene;
        QPointer<MeshDocument> document;
    };
    std::vector<Entry> entries_;
};

bool holds(const MeshDocument* document, const MeshModel& mesh) {
    if (!document) return false;
    const std::vector<const MeshModel*> layers = layers_of(*document);
    return std::find(layers.begin(), layers.end(), &mesh) != layers.end();
}

}  // namespace

MLSceneGLSharedDataContext* scene_of(const MeshModel& mesh) {
    static WatchedDocuments documents;
    MLSceneGLSharedDataContext* found = nullptr;
    // A widget that is never shown and has no parent; all are visited, to watch them.
    for (QWidget* widget : QApplication::allWidgets()) {
        auto* scene = qobject_cast<MLSceneGLSharedDataContext*>(widget);
        if (scene && holds(documents.of(scene), mesh)) found = scene;
    }
    return found;
}

MLSceneGLSharedDataContext* scene_of(const MeshDocument& document) {
    for (QWidget* widget : QApplication::allWidgets())
        if (auto* scene = qobject_cast<MLSceneGLSharedDataContext*>(widget))
            if (&scene->meshDoc() == &document) return scene;
    return nullptr;
}

MeshDocument* document_of(const MeshModel& mesh) {
    MLSceneGLSharedDataContext* scene = scene_of(mesh);
    return scene ? &scene->meshDoc() : nullptr;
}

std::vector<const MeshModel*> layers_of(const MeshDocument& document) {
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

std::vector<int> layer_ids(const MeshDocument& document, bool only_shown) {
    std::vector<int> ids;
    for (const MeshModel* layer : layers_of(document))
        if (!only_shown || layer->isVisible()) ids.push_back(int(layer->id()));
    std::sort(ids.begin(), ids.end());
    return ids;
}

void write_on_view(GLLogStream& log, const QString& title, const QString& mesh,
                   const QString& text) {
#if MESHLAB_API < 2022
    log.RealTimeLog(title, mesh, text);
#else
    log.realTimeLog(title, mesh, text);
#endif
}

void record_as(const QString& filter, const RichParameterList& parameters, MeshDocument& document) {
    QTimer::singleShot(0, &document, [=, &document] {  // some MeshLabs record afterwards
#if MESHLAB_API < 2022
        FilterScript& history = *document.filterHistory;
#else
        FilterScript& history = document.filterHistory;
#endif
        if (!history.isEmpty() && history.last().first == filter)
            history.last().second = parameters;
    });
}

}  // namespace meshlab_host
