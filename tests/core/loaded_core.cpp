// SPDX-License-Identifier: GPL-3.0-or-later
// The core as in a plugin, for unload_core. With more of the core, the compiler's unique symbols
// keep a library from being unloaded at all.
#include <atomic>

#include "laplacian_lines/threads.h"

extern "C" int count_on_threads(int count) {
    std::atomic<int> done{0};
    laplacian_lines::in_parallel(std::size_t(count), [&](std::size_t) { ++done; });
    return done;
}
