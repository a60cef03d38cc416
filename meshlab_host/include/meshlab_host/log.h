// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class GLLogStream;
class MeshModel;

namespace meshlab_host {

/// The log of the document of `mesh`, the one that is handed to whoever draws it. Null if the
/// document cannot be found, as in programs without MeshLab's GUI. GUI thread only.
GLLogStream* documentLog(const MeshModel& mesh);

/// Whether the log has this line. Previews of filters take lines out of it again.
bool hasLine(const GLLogStream& log, const QString& line);

/// Shows text in the corner of the view until the next redraw. `mesh` is printed only where two
/// boxes have the same title. GUI thread only, while drawing.
void writeOnView(GLLogStream& log, const QString& title, const QString& mesh, const QString& text);

}  // namespace meshlab_host
