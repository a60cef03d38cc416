// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/affordable_threads.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace laplacian_lines {
namespace {

/// Starts threads, all of them alive at once, until there are `wanted` with the calling one.
int start_threads(int wanted) {
    std::vector<std::thread> threads;
    std::mutex gate;
    {
        const std::lock_guard<std::mutex> closed(gate);
        try {
            threads.reserve(std::size_t(wanted));
            while (int(threads.size()) + 1 < wanted)
                threads.emplace_back([&] { const std::lock_guard<std::mutex> passed(gate); });
        } catch (const std::exception&) {  // those that there are have to do
        }
    }
    for (std::thread& thread : threads)
        thread.join();
    return int(threads.size()) + 1;
}

}  // namespace

int affordable_threads(int wanted) {
    // OpenMP keeps what it has started.
    thread_local int known = 1;
    if (wanted > known) known = std::max(known, start_threads(wanted));
    return std::min(wanted, known);
}

}  // namespace laplacian_lines
