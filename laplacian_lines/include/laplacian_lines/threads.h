// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace laplacian_lines {

/// How many threads a call of the core uses at most, with its own: LAPLACIAN_LINES_THREADS in the
/// environment, else one per processor. The core starts its others when they are first needed; they
/// sleep between calls. Results do not depend on them. Thread-safe.
int thread_limit();

/// For all later calls, from any thread; less than 1: the initial limit. Thread-safe.
void set_thread_limit(int threads);

}  // namespace laplacian_lines
