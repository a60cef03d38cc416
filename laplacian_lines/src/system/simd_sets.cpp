// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/simd_sets.h"

#include <cstdlib>

namespace laplacian_lines {
namespace {

bool is_available(InstructionSet set) {
#ifdef LAPLACIAN_LINES_X86_SETS
    __builtin_cpu_init();
    if (set == InstructionSet::Avx512) return __builtin_cpu_supports("x86-64-v4");
    if (set == InstructionSet::Avx2) return __builtin_cpu_supports("x86-64-v3");
#endif
    return set == InstructionSet::Baseline;
}

InstructionSet widest() {
    const char* const wanted = std::getenv("LAPLACIAN_LINES_VECTOR_BYTES");
    const unsigned long bytes = wanted ? std::strtoul(wanted, nullptr, 10) : 64;
    if (bytes >= 64 && is_available(InstructionSet::Avx512)) return InstructionSet::Avx512;
    if (bytes >= 32 && is_available(InstructionSet::Avx2)) return InstructionSet::Avx2;
    return InstructionSet::Baseline;
}

InstructionSet& chosen() {
    static InstructionSet set = widest();
    return set;
}

}  // namespace

InstructionSet instruction_set() {
    return chosen();
}

bool use_instruction_set(InstructionSet set) {
    const bool available = is_available(set);
    if (available) chosen() = set;
    return available;
}

}  // namespace laplacian_lines
