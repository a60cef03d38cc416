// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class GLLogStream;

namespace meshlab_host {

/// Adds a line to the document's log (layer dialog, meshlabserver's output). GUI thread only.
void writeLog(GLLogStream& log, const QString& line);

/// Whether this is one of the latest lines of the log.
bool endsWith(const GLLogStream& log, const QString& line);

/// Shows text in the corner of the view until the next redraw. `mesh` is printed only where two
/// boxes have the same title. GUI thread only, while drawing.
void writeOnView(GLLogStream& log, const QString& title, const QString& mesh, const QString& text);

}  // namespace meshlab_host
