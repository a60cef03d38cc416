// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <map>

class GLLogStream;

/// What was said of meshes without lines since these were last drawn, by log and mesh: once, not at
/// every redraw. Logs are keys unless they are references. GUI thread only.
class Complaints {
public:
    /// Whether the line was the last one said of the mesh and is still in the log.
    bool isSaid(const GLLogStream& log, int mesh, const QString& line) const;
    /// The line was just said, in this log if it is not null.
    void note(const GLLogStream* log, int mesh, const QString& line);
    /// The mesh has lines again.
    void forget(const GLLogStream& log, int mesh);
    /// Call it when a view closes: a new document may get the address of the old.
    void forgetAll();

private:
    struct Complaint {
        QString line;
        bool is_kept = false;  ///< by the log; some hosts show a line and forget it
    };
    std::map<std::pair<const GLLogStream*, int>, Complaint> complaints_;
};
