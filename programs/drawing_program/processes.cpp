// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawings.h"

#include <QFile>
#include <QProcess>
#include <QThread>
#include <algorithm>
#include <memory>

#include "mesh_reading.h"

namespace {

// Measured: six views of a part of 84,000 triangles with many edges take 6.7 kB a triangle, of a
// scan with 14 million 180 bytes. So large ones are drawn one at a time.
constexpr double bytes_per_triangle = 8e3, least_bytes = 200e6;
constexpr double share_of_free_memory = 0.8;
constexpr int wait_ms = 20;

double freeMemory() {
    QFile file("/proc/meminfo");
    if (!file.open(QIODevice::ReadOnly)) return 4e9;
    for (const QByteArray& line : file.readAll().split('\n'))
        if (line.startsWith("MemAvailable:"))
            return 1024 * line.mid(13).simplified().split(' ').first().toDouble();
    return 4e9;
}

struct Running {
    const Job* job;
    double memory;
    std::unique_ptr<QProcess> process;
};

/// Its last line, without the names of program and mesh.
QString complaintOf(QProcess& process, const QString& mesh) {
    if (process.error() == QProcess::FailedToStart) return process.errorString();
    if (process.exitStatus() == QProcess::CrashExit)
        return "the program was ended by a signal, perhaps because it ran out of memory.";
    const QStringList lines =
        QString::fromLocal8Bit(process.readAllStandardError()).split('\n', Qt::SkipEmptyParts);
    QString last = lines.isEmpty() ? "without a reason given" : lines.last();
    for (const QString& prefix : {QString("laplacian-lines: "), mesh + ": "})
        if (last.startsWith(prefix)) last = last.mid(prefix.size());
    return last;
}

bool hasEnded(QProcess& process) {
    return process.state() == QProcess::NotRunning || process.waitForFinished(wait_ms) ||
           process.state() == QProcess::NotRunning;
}

std::unique_ptr<QProcess> start(const QString& program, const Job& job, int threads) {
    auto process = std::make_unique<QProcess>();
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("LAPLACIAN_LINES_THREADS", QString::number(threads));
    process->setProcessEnvironment(environment);
    process->start(program, job.arguments);
    return process;
}

/// At most, as a rule.
double memoryFor(const QString& mesh) {
    return least_bytes + bytes_per_triangle * expectedTriangles(mesh);
}

}  // namespace

void runJobs(const QString& program, const std::vector<Job>& jobs,
             const std::function<void(const Job&, const QString&)>& end) {
    const int processors = std::max(1, QThread::idealThreadCount());
    const int at_once = std::max(1, std::min(processors, int(jobs.size())));
    const double memory = share_of_free_memory * freeMemory();
    std::vector<Running> running;
    double taken = 0;
    for (std::size_t next = 0; next < jobs.size() || !running.empty();) {
        while (next < jobs.size() && int(running.size()) < at_once) {
            const double needed = memoryFor(jobs[next].mesh);
            if (!running.empty() && taken + needed > memory) break;
            running.push_back(
                {&jobs[next], needed, start(program, jobs[next], processors / at_once)});
            taken += needed;
            ++next;
        }
        for (auto r = running.begin(); r != running.end();) {
            if (!hasEnded(*r->process)) {
                ++r;
                continue;
            }
            const bool succeeded = r->process->exitStatus() == QProcess::NormalExit &&
                                   r->process->exitCode() == 0 &&
                                   r->process->error() != QProcess::FailedToStart;
            end(*r->job, succeeded ? QString() : complaintOf(*r->process, r->job->mesh));
            taken -= r->memory;
            r = running.erase(r);
        }
    }
}
