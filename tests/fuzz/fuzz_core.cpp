// SPDX-License-Identifier: GPL-3.0-or-later
// The case of wild_case.h.
#include <cstdio>
#include <cstdlib>

#include "wild_case.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::string found = wild::violation_of_bytes(bytes, size);
    if (found.empty()) return 0;
    std::fprintf(stderr, "core: %s\n", found.c_str());
    std::abort();
}
