// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QString>

class GLLogStream;

namespace server {

/// Lines on stdout and in the log file, if any; errors on stderr and in the log file.
class Report {
public:
    /// Appends to the file from now on. @throws MLException
    void openLog(const QString& file);

    void say(const QString& line);
    void error(const QString& line);
    /// What filters have added to MeshLab's log since the last call.
    void sayNewLines(const GLLogStream& log);

private:
    void write(FILE* stream, const QString& line);

    QFile log_;
    int lines_seen_ = 0;
};

}  // namespace server
