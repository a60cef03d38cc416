// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <functional>
#include <vector>

/// A drawing of a collection, made by a process of its own.
struct Job {
    std::size_t number;
    QString mesh;
    QStringList arguments;
};

/// Runs `program` for each job, in their order, as many at once as there are processors and as fit
/// the memory; at least one. Processors are shared among them as threads. `end` is called for each
/// as it ends, with the reason why it failed, or with an empty text.
void runJobs(const QString& program, const std::vector<Job>& jobs,
             const std::function<void(const Job&, const QString& why)>& end);

/// Bytes that drawing a mesh takes at most, from the size of its file.
double memoryFor(const QString& mesh);
