// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace laplacian_lines {

/// How many threads a call of the core uses at most, with its own: LAPLACIAN_LINES_THREADS in the
/// environment, else one per processor. The core starts its others when they are first needed; they
/// sleep between calls. Results do not depend on them. Thread-safe.
int thread_limit();

/// For all later calls, from any thread; less than 1: the initial limit. Thread-safe.
void set_thread_limit(int threads);

/// Runs body(i) for i in [0, count) on the calling thread and on idle ones of the core. Threads
/// take one i at a time, in order, so each should be some work. The body writes only to what
/// belongs to i, so that the number of threads does not matter, and may run loops of its own. The
/// first exception stops all and is rethrown. Thread-safe.
void in_parallel(std::size_t count, const std::function<void(std::size_t)>& body);

}  // namespace laplacian_lines
