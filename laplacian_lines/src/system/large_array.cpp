// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/large_array.h"

#include <algorithm>
#include <cstdint>

#include "system/parallel.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace laplacian_lines {
namespace {

constexpr std::size_t kPage = 4096, kHugePage = 2u << 20;

}  // namespace

void advise_huge_pages(void* memory, std::size_t bytes) {
#ifdef __linux__
    const std::uintptr_t begin =
        (reinterpret_cast<std::uintptr_t>(memory) + kPage - 1) & ~(kPage - 1);
    const std::uintptr_t end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) & ~(kPage - 1);
    if (end < begin + 2 * kHugePage) return;
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);  // no harm if it fails
#else
    (void)memory, (void)bytes;
#endif
}

void clear_pages(void* memory, std::size_t bytes) {
    constexpr std::size_t kMany = 4 * kHugePage;  // enough for several threads
    if (bytes < kMany) return;
    in_parallel(bytes / kHugePage + 1, [&](std::size_t i) {
        const std::size_t end = std::min(bytes, (i + 1) * kHugePage);
        for (std::size_t at = i * kHugePage; at < end; at += kPage)
            static_cast<volatile char*>(memory)[at] = 0;
    });
}

}  // namespace laplacian_lines
