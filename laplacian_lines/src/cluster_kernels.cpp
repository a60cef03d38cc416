// SPDX-License-Identifier: GPL-3.0-or-later
#include "cluster_kernels.h"

#include <initializer_list>

namespace laplacian_lines {

extern const ClusterKernels kClusterKernelsBaseline, kClusterKernelsAvx2, kClusterKernelsAvx512;

namespace {

const ClusterKernels* kernels_for(InstructionSet set) {
    switch (set) {
#ifdef LAPLACIAN_LINES_X86_KERNELS
        case InstructionSet::Avx512:
            return __builtin_cpu_supports("x86-64-v4") ? &kClusterKernelsAvx512 : nullptr;
        case InstructionSet::Avx2:
            return __builtin_cpu_supports("x86-64-v3") ? &kClusterKernelsAvx2 : nullptr;
#endif
        case InstructionSet::Baseline:
            return &kClusterKernelsBaseline;
        default:
            return nullptr;
    }
}

const ClusterKernels* fastest_kernels() {
    for (InstructionSet set : {InstructionSet::Avx512, InstructionSet::Avx2})
        if (const ClusterKernels* kernels = kernels_for(set)) return kernels;
    return &kClusterKernelsBaseline;
}

const ClusterKernels*& chosen_kernels() {
    static const ClusterKernels* kernels = fastest_kernels();
    return kernels;
}

}  // namespace

const ClusterKernels& cluster_kernels() {
    return *chosen_kernels();
}

bool use_instruction_set(InstructionSet set) {
    const ClusterKernels* kernels = kernels_for(set);
    if (kernels) chosen_kernels() = kernels;
    return kernels;
}

}  // namespace laplacian_lines
