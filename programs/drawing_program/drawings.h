// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <functional>
#include <vector>

#include "command_line.h"

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

/// Reads the meshes, draws them together, writes the file, and with it the view for a contact
/// sheet, if that is wanted.
/// @throws laplacian_lines::Error with a sentence for users; std::bad_alloc.
void drawOne(const CommandLine& commands);

/// Draws each mesh of a collection by a process of its own, as many at once as there are
/// processors and as fit the memory, and then a contact sheet of all. What an earlier run has drawn
/// of the same mesh with the same options and program stays. Says in a line what became of each
/// mesh; whether all could be drawn.
/// @throws laplacian_lines::Error if there is nothing to draw or the folder cannot be written.
bool drawCollection(const CommandLine& commands);
