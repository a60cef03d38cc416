// SPDX-License-Identifier: GPL-3.0-or-later
#include <malloc.h>
#include <QDir>

#include "command_table.h"
#include "process.h"

namespace driver {
namespace {

constexpr double megabyte = 1 << 20;
double noted = 0, allowed = 0;

/// Megabytes.
double heapInUse() {
    const struct mallinfo2 info = mallinfo2();
    return double(info.uordblks + info.hblkhd) / megabyte;
}

double grownBy() {
    const double grown = heapInUse() - noted;
    say(QString("memory in use has grown by %1 MB").arg(grown, 0, 'f', 2).toStdString());
    return grown;
}

void noteMemory(const Command&) {
    noted = heapInUse();
    allowed = 0;
}

// MeshLab itself keeps memory at each filter.
void allowMemoryGrowth(const Command&) {
    allowed = grownBy();
    noted = heapInUse();
}

void expectMemoryGrowth(const Command& command) {
    const double grown = grownBy();
    if (grown > allowed + command.number(0))
        throw CommandError(QString("memory in use has grown by %1 MB").arg(grown, 0, 'f', 2));
}

int threads() {
    return QDir("/proc/self/task").entryList(QDir::Dirs | QDir::NoDotAndDotDot).size();
}

int noted_threads = 0;

void noteThreads(const Command&) {
    noted_threads = threads();
}

Outcome expectNoMoreThreads(const Command&) {
    return threads() <= noted_threads ? Outcome::Done : Outcome::Retry;
}

}  // namespace

void addMemoryCommands(CommandTable& table) {
    table.addSimple("note-memory", noteMemory);
    table.addSimple("allow-memory-growth", allowMemoryGrowth);
    table.addSimple("expect-memory-growth", expectMemoryGrowth);
    table.addSimple("note-threads", noteThreads);
    table.add("expect-no-more-threads", expectNoMoreThreads);
}

}  // namespace driver
