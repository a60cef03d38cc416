// SPDX-License-Identifier: GPL-3.0-or-later
#define SIMD_NAMESPACE simd_baseline
#define SIMD_TABLE kSimdBaseline
#define SIMD_SET InstructionSet::Baseline
#include "redraw/simd/simd_all.h"
