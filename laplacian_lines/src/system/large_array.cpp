// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/large_array.h"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace laplacian_lines {

void advise_huge_pages(void* memory, std::size_t bytes) {
#ifdef __linux__
    constexpr std::uintptr_t kPage = 4096, kHugePage = 2u << 20;
    const std::uintptr_t begin =
        (reinterpret_cast<std::uintptr_t>(memory) + kPage - 1) & ~(kPage - 1);
    const std::uintptr_t end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) & ~(kPage - 1);
    if (end < begin + 2 * kHugePage) return;
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);  // no harm if it fails
#else
    (void)memory, (void)bytes;
#endif
}

}  // namespace laplacian_lines
