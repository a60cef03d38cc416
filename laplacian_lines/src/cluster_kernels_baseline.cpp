// SPDX-License-Identifier: GPL-3.0-or-later
#define KERNEL_NAMESPACE kernels_baseline
#define KERNEL_TABLE kClusterKernelsBaseline
#define KERNEL_SET InstructionSet::Baseline
#include "cluster_kernels_impl.h"
