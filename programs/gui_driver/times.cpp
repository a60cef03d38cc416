// SPDX-License-Identifier: GPL-3.0-or-later
#include <GL/glew.h>  // before any other GL header

#include "times.h"

#include <time.h>
#include <QFile>
#include <array>

#include "command_table.h"
#include "gui.h"

namespace driver {
namespace {

constexpr clockid_t clocks[] = {CLOCK_MONOTONIC, CLOCK_THREAD_CPUTIME_ID, CLOCK_PROCESS_CPUTIME_ID};

std::array<double, 3> milliseconds() {
    std::array<double, 3> result;
    for (std::size_t i = 0; i < result.size(); ++i) {
        timespec now;
        clock_gettime(clocks[i], &now);
        result[i] = 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
    }
    return result;
}

/// Software renderers draw in threads that outlast the redraw.
void finishDrawing() {
    requireView()->makeCurrent();
    glFinish();
}

}  // namespace

void appendTimes(const QString& file_name, const std::function<void()>& action) {
    finishDrawing();
    const auto begin = milliseconds();
    action();
    finishDrawing();
    const auto end = milliseconds();
    QFile file(file_name);
    if (!file.open(QIODevice::Append)) throw CommandError("cannot write " + file_name);
    for (std::size_t i = 0; i < end.size(); ++i)
        file.write(QByteArray::number(end[i] - begin[i], 'f', 2) +
                   (i + 1 < end.size() ? " " : "\n"));
}

}  // namespace driver
