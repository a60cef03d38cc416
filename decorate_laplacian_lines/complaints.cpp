// SPDX-License-Identifier: GPL-3.0-or-later
#include "complaints.h"

#include "meshlab_host/documents.h"

bool Complaints::isSaid(const GLLogStream& log, int mesh, const QString& line) const {
    const auto last = complaints_.find({&log, mesh});
    if (last == complaints_.end() || last->second.line != line) return false;
    return !last->second.is_kept || meshlab_host::hasLine(log, line);
}

void Complaints::note(const GLLogStream* log, int mesh, const QString& line) {
    complaints_[{log, mesh}] = {line, log && meshlab_host::hasLine(*log, line)};
}

void Complaints::forget(const GLLogStream& log, int mesh) {
    complaints_.erase({&log, mesh});
}

void Complaints::forgetAll() {
    complaints_.clear();
}
