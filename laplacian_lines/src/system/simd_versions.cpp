// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/simd_versions.h"

#include <cstdlib>

namespace laplacian_lines {
namespace {

std::size_t processor_bytes() {
#ifdef LAPLACIAN_LINES_X86_VERSIONS
    __builtin_cpu_init();
    if (__builtin_cpu_supports("x86-64-v4")) return 64;
    if (__builtin_cpu_supports("x86-64-v3")) return 32;
#endif
    return 16;
}

}  // namespace

std::size_t vector_bytes() {
    const std::size_t most = processor_bytes();
    const char* const wanted = std::getenv("LAPLACIAN_LINES_VECTOR_BYTES");
    const std::size_t bytes = wanted ? std::strtoul(wanted, nullptr, 10) : most;
    return bytes < most ? bytes : most;
}

}  // namespace laplacian_lines
