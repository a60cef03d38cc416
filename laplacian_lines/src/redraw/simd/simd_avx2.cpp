// SPDX-License-Identifier: GPL-3.0-or-later
#define SIMD_NAMESPACE simd_avx2
#define SIMD_TABLE kSimdAvx2
#define SIMD_SET InstructionSet::Avx2
#include "redraw/simd/simd_all.h"
