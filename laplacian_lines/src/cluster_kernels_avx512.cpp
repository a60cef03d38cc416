// SPDX-License-Identifier: GPL-3.0-or-later
#define KERNEL_NAMESPACE kernels_avx512
#define KERNEL_TABLE kClusterKernelsAvx512
#define KERNEL_SET InstructionSet::Avx512
#include "cluster_kernels_impl.h"
