// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <map>

class GLLogStream;

/// What has been said of meshes without lines, by log and mesh, since their lines were last drawn:
/// once, not at every redraw. Logs only serve as names, unless they are passed as references. GUI
/// thread only.
class Complaints {
public:
    /// Whether the log's reader knows this line: it was the last one said of the mesh, and has not
    /// been taken out of the log since.
    bool isSaid(const GLLogStream& log, int mesh, const QString& line) const;
    /// The line has just been said, in this log if it is not null.
    void note(const GLLogStream* log, int mesh, const QString& line);
    /// The mesh has lines again.
    void forget(const GLLogStream& log, int mesh);
    /// To be called when a view closes: another document may get the place of a closed one.
    void forgetAll();

private:
    struct Complaint {
        QString line;
        bool is_kept = false;  ///< by the log; some hosts show a line and forget it
    };
    std::map<std::pair<const GLLogStream*, int>, Complaint> complaints_;
};
