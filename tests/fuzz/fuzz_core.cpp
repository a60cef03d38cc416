// SPDX-License-Identifier: GPL-3.0-or-later
// The case of wild_case.h named by PART.
#include <cstdio>
#include <cstdlib>

#include "wild_case.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    test_meshes::Choices choices(bytes, size);
    const std::string found = wild::CASE(choices);
    if (found.empty()) return 0;
    std::fprintf(stderr, PART ": %s\n", found.c_str());
    std::abort();
}
