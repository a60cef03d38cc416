// SPDX-License-Identifier: GPL-3.0-or-later
#define SIMD_NAMESPACE simd_avx512
#define SIMD_TABLE kSimdAvx512
#define SIMD_SET InstructionSet::Avx512
#include "redraw/simd/simd_all.h"
