// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <functional>
#include <vector>

#include "command_line.h"

/// A drawing of a collection, in its own process.
struct Job {
    std::size_t number;
    QString mesh;
    QStringList arguments;
};

/// Runs `program` for each job in order, as many at once as processors and memory allow, at least
/// one; they share the processors as threads. `end` gets each job with the reason why it failed, or
/// "".
void runJobs(const QString& program, const std::vector<Job>& jobs,
             const std::function<void(const Job&, const QString& why)>& end);

/// Draws the meshes together into the file and, if wanted, the view for a contact sheet.
/// @throws laplacian_lines::Error with a sentence for users; std::bad_alloc
void drawOne(const CommandLine& commands);

/// Draws each mesh of a collection in its own process, then a contact sheet of all; keeps drawings
/// of the same mesh by the same options and program. Prints a line per mesh. Whether all were
/// drawn. @throws laplacian_lines::Error if there is nothing to draw or the folder is not writable
bool drawCollection(const CommandLine& commands);
