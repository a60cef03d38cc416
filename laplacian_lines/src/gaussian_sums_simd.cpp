// SPDX-License-Identifier: GPL-3.0-or-later
#include "gaussian_sums_simd.h"

#include <cstdint>

// One version for each level of the instruction set, chosen when the program starts. Named levels
// (GCC 12) look at what the processor can do; "arch=" with a processor's name would look for that
// very model. Sanitizers cannot resolve clones.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 12 && \
    !defined(LAPLACIAN_LINES_NO_CLONES)
#define LAPLACIAN_LINES_CLONES \
    __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define LAPLACIAN_LINES_CLONES
#endif

namespace laplacian_lines {
namespace {

typedef float Floats __attribute__((vector_size(4 * kLanes)));
typedef std::int32_t Ints __attribute__((vector_size(4 * kLanes)));

inline __attribute__((always_inline)) Floats load(const float* p) {
    return *reinterpret_cast<const Floats*>(p);
}
inline __attribute__((always_inline)) void store(float* p, Floats v) {
    *reinterpret_cast<Floats*>(p) = v;
}

/// All bits set where v < 0. Comparisons of vectors would be lowered to scalar code before the
/// function is cloned for wider instruction sets; shifts are not.
inline __attribute__((always_inline)) Ints is_negative(Floats v) {
    return (Ints)v >> 31;
}

/// 2^x for x <= 0, relative error 2e-7; tiny results become about 1e-37 instead of 0.
inline __attribute__((always_inline)) Floats exp2_of_negative(Floats x) {
    constexpr float kRound = 12582912.f;  // 1.5·2^23: adding it rounds to an integer
    const Ints too_small = is_negative(x + 124.f);
    x = (Floats)(((Ints)x & ~too_small) | ((Ints)(Floats{} - 124.f) & too_small));
    const Floats shifted = x + kRound;
    const Floats f = x - (shifted - kRound);  // [-0.5, 0.5]
    // Taylor series of 2^f; coefficients ln(2)^k / k!.
    Floats y = 1.5403530e-4f * f + 1.3333558e-3f;
    y = y * f + 9.6181291e-3f;
    y = y * f + 5.5504109e-2f;
    y = y * f + 2.4022651e-1f;
    y = y * f + 6.9314718e-1f;
    y = y * f + 1.f;
    // The integer sits in the low bits of `shifted`; adding it to the exponent field scales by 2^n.
    const Ints n = (Ints)shifted << 23;
    return (Floats)((Ints)y + n);
}

}  // namespace

LAPLACIAN_LINES_CLONES
void sum_gaussians(const GaussianTargets& t, const GaussianSource* sources,
                   std::size_t source_count, GaussianLaneSums& sums) {
    const Floats x = load(t.x), y = load(t.y), z = load(t.z);
    const Floats nx = load(t.nx), ny = load(t.ny), nz = load(t.nz);
    const Floats reference_cosine = load(t.reference_cosine);
    const Floats squared_cutoff = load(t.squared_cutoff), exponent = load(t.exponent);
    Floats mass{}, mx{}, my{}, mz{}, snx{}, sny{}, snz{};
    for (std::size_t i = 0; i < source_count; ++i) {
        const GaussianSource& s = sources[i];
        const Floats dx = s.x - x, dy = s.y - y, dz = s.z - z;
        const Floats squared = dx * dx + dy * dy + dz * dz;
        const Floats cosine = s.nx * nx + s.ny * ny + s.nz * nz + reference_cosine;
        const Ints outside =
            is_negative(squared_cutoff - squared) | is_negative(cosine - t.least_cosine);
        const Floats g =
            exp2_of_negative(squared * exponent + t.normal_exponent * (1.f - cosine)) * s.mass;
        const Floats w = (Floats)((Ints)g & ~outside);
        mass += w;
        mx += w * dx;
        my += w * dy;
        mz += w * dz;
        snx += w * s.nx;
        sny += w * s.ny;
        snz += w * s.nz;
    }
    store(sums.mass, mass);
    store(sums.mx, mx);
    store(sums.my, my);
    store(sums.mz, mz);
    store(sums.nx, snx);
    store(sums.ny, sny);
    store(sums.nz, snz);
}

}  // namespace laplacian_lines
