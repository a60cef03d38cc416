// SPDX-License-Identifier: GPL-3.0-or-later
#define KERNEL_NAMESPACE kernels_avx2
#define KERNEL_TABLE kClusterKernelsAvx2
#define KERNEL_SET InstructionSet::Avx2
#include "cluster_kernels_impl.h"
