// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace laplacian_lines {

/// How many threads a call of the core runs on at most, the calling one among them: at first what
/// the environment variable LAPLACIAN_LINES_THREADS says, else as many as there are processors for
/// the process. The others are the core's own. They are started when they are first needed, sleep
/// between calls, and join in where they are free; no result depends on how many do. Thread-safe.
int thread_limit();

/// For all calls from now on, from any thread; less than 1: as at first. Thread-safe.
void set_thread_limit(int threads);

}  // namespace laplacian_lines
