// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <tuple>
#include <vector>

#include "laplacian_lines/threads.h"
#include "system/parallel.h"

namespace laplacian_lines {

/// Cuts `whole` in two, these again and so on, a level in parallel, until all threads have a share
/// or parts are `small`. cut(part) returns a pair of about equal sizes and writes only to what
/// belongs to its part. The result is a heap: part i is cut into 2i + 1 and 2i + 2; the first size
/// / 2 are cut. The number of threads decides on the number of levels only.
template <class Part, class Cut>
std::vector<Part> halve_in_parallel(const Part& whole, std::size_t small, Cut cut) {
    const auto threads = std::size_t(thread_limit());
    const std::size_t enough = threads > 1 ? 8 * threads : 1;
    std::vector<Part> parts = {whole};
    for (std::size_t level = 0; parts.size() - level < enough && parts[level].size() > small;) {
        const std::size_t next = parts.size();
        parts.resize(2 * next + 1);
        in_parallel(next - level, [&](std::size_t i) {
            std::tie(parts[next + 2 * i], parts[next + 2 * i + 1]) = cut(parts[level + i]);
        });
        level = next;
    }
    return parts;
}

}  // namespace laplacian_lines
