// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/log.h"

#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

void writeLog(GLLogStream& log, const QString& line) {
#if MESHLAB_API < 2022
    log.Log(GLLogStream::FILTER, line);
#else
    log.log(GLLogStream::FILTER, line);
#endif
}

void writeOnView(GLLogStream& log, const QString& title, const QString& mesh, const QString& text) {
#if MESHLAB_API < 2022
    log.RealTimeLog(title, mesh, text);
#else
    log.realTimeLog(title, mesh, text);
#endif
}

}  // namespace meshlab_host
