// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/log.h"

#include <algorithm>

#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

void writeLog(GLLogStream& log, const QString& line) {
#if MESHLAB_API < 2022
    log.Log(GLLogStream::FILTER, line);
#else
    log.log(GLLogStream::FILTER, line);
#endif
}

bool endsWith(const GLLogStream& log, const QString& line) {
    constexpr int last = 4;
    const auto& lines = log.logStringList();
    for (int i = std::max(0, int(lines.size()) - last); i < lines.size(); ++i)
        if (lines[i].second == line) return true;
    return false;
}

void writeOnView(GLLogStream& log, const QString& title, const QString& mesh, const QString& text) {
#if MESHLAB_API < 2022
    log.RealTimeLog(title, mesh, text);
#else
    log.realTimeLog(title, mesh, text);
#endif
}

}  // namespace meshlab_host
