// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/log.h"

#include <algorithm>

#include "scene.h"

namespace meshlab_host {

GLLogStream* documentLog(const MeshModel& mesh) {
    MLSceneGLSharedDataContext* scene = sceneOf(mesh);
    return scene ? &scene->meshDoc().Log : nullptr;
}

bool hasLine(const GLLogStream& log, const QString& line) {
    const auto& lines = log.logStringList();
    return std::any_of(lines.begin(), lines.end(),
                       [&](const auto& entry) { return entry.second == line; });
}

void writeOnView(GLLogStream& log, const QString& title, const QString& mesh, const QString& text) {
#if MESHLAB_API < 2022
    log.RealTimeLog(title, mesh, text);
#else
    log.realTimeLog(title, mesh, text);
#endif
}

}  // namespace meshlab_host
