// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/scene.h"

#include <QApplication>
#include <QPointer>
#include <algorithm>

#include "meshlab_host/documents.h"

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
    const std::vector<const MeshModel*> layers = layersOf(*document);
    return std::find(layers.begin(), layers.end(), &mesh) != layers.end();
}

}  // namespace

MLSceneGLSharedDataContext* sceneOf(const MeshModel& mesh) {
    static WatchedDocuments documents;
    MLSceneGLSharedDataContext* found = nullptr;
    // A widget that is never shown and has no parent; all are visited, to watch them.
    for (QWidget* widget : QApplication::allWidgets()) {
        auto* scene = qobject_cast<MLSceneGLSharedDataContext*>(widget);
        if (scene && holds(documents.of(scene), mesh)) found = scene;
    }
    return found;
}

MLSceneGLSharedDataContext* sceneOf(const MeshDocument& document) {
    if (!qobject_cast<QApplication*>(QCoreApplication::instance())) return nullptr;
    for (QWidget* widget : QApplication::allWidgets())
        if (auto* scene = qobject_cast<MLSceneGLSharedDataContext*>(widget))
            if (&scene->meshDoc() == &document) return scene;
    return nullptr;
}

}  // namespace meshlab_host
