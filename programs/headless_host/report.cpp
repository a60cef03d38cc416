// SPDX-License-Identifier: GPL-3.0-or-later
#include "report.h"

#include <common/GLLogStream.h>
#include <common/mlexception.h>

#include <cstdio>

namespace server {

void Report::openLog(const QString& file) {
    log_.setFileName(file);
    if (!log_.open(QIODevice::WriteOnly | QIODevice::Append | QIODevice::Text))
        throw MLException("The log " + file + " cannot be written: " + log_.errorString());
}

void Report::say(const QString& line) {
    write(stdout, line);
}

void Report::error(const QString& line) {
    write(stderr, "laplacian_lines_server: " + line);
}

void Report::sayNewLines(const GLLogStream& log) {
    QStringList lines;
    log.print(lines);
    for (; lines_seen_ < lines.size(); ++lines_seen_)
        say(lines[lines_seen_]);
}

void Report::write(FILE* stream, const QString& line) {
    const QByteArray bytes = line.toLocal8Bit() + '\n';
    std::fputs(bytes.constData(), stream);
    std::fflush(stream);
    if (log_.isOpen()) {
        log_.write(bytes);
        log_.flush();
    }
}

}  // namespace server
