// SPDX-License-Identifier: GPL-3.0-or-later
#include "redraw/simd/simd_functions.h"

#include <initializer_list>

namespace laplacian_lines {

extern const SimdFunctions kSimdBaseline, kSimdAvx2, kSimdAvx512;

namespace {

const SimdFunctions* functions_for(InstructionSet set) {
    switch (set) {
#ifdef LAPLACIAN_LINES_X86_SIMD
        case InstructionSet::Avx512:
            return __builtin_cpu_supports("x86-64-v4") ? &kSimdAvx512 : nullptr;
        case InstructionSet::Avx2:
            return __builtin_cpu_supports("x86-64-v3") ? &kSimdAvx2 : nullptr;
#endif
        case InstructionSet::Baseline:
            return &kSimdBaseline;
        default:
            return nullptr;
    }
}

const SimdFunctions* fastest_functions() {
    for (InstructionSet set : {InstructionSet::Avx512, InstructionSet::Avx2})
        if (const SimdFunctions* functions = functions_for(set)) return functions;
    return &kSimdBaseline;
}

const SimdFunctions*& chosen_functions() {
    static const SimdFunctions* functions = fastest_functions();
    return functions;
}

}  // namespace

const SimdFunctions& simd_functions() {
    return *chosen_functions();
}

bool use_instruction_set(InstructionSet set) {
    const SimdFunctions* functions = functions_for(set);
    if (functions) chosen_functions() = functions;
    return functions;
}

}  // namespace laplacian_lines
