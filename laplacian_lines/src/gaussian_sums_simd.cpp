// SPDX-License-Identifier: GPL-3.0-or-later
#include "gaussian_sums_simd.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "facing_weight.h"
#include "simd_clones.h"

namespace laplacian_lines {
namespace {

typedef float Floats __attribute__((vector_size(4 * kLanes)));
typedef std::int32_t Ints __attribute__((vector_size(4 * kLanes)));

LAPLACIAN_LINES_INLINE Floats load(const float* p) {
    return *reinterpret_cast<const Floats*>(p);
}
LAPLACIAN_LINES_INLINE void store(float* p, Floats v) {
    *reinterpret_cast<Floats*>(p) = v;
}

/// All bits set where v < 0. Comparisons of vectors would be lowered to scalar code before the
/// function is cloned for wider instruction sets; shifts are not.
LAPLACIAN_LINES_INLINE Ints is_negative(Floats v) {
    return (Ints)v >> 31;
}

/// 2^x for x <= 0, relative error 2e-7; tiny results become about 1e-37 instead of 0.
LAPLACIAN_LINES_INLINE Floats exp2_of_negative(Floats x) {
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

typedef float Source __attribute__((vector_size(sizeof(GaussianSource))));

}  // namespace

LAPLACIAN_LINES_CLONES
std::size_t collect_sources(const GaussianSource* sources, std::size_t count,
                            const GaussianSource& shift, const float half_size[3],
                            float squared_distance, GaussianSource* kept) {
    const Source by = *reinterpret_cast<const Source*>(&shift);
    std::size_t kept_count = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Source s = *reinterpret_cast<const Source*>(&sources[i]) + by;
        *reinterpret_cast<Source*>(&kept[kept_count]) = s;
        const float x = std::max(std::abs(s[0]) - half_size[0], 0.f);
        const float y = std::max(std::abs(s[1]) - half_size[1], 0.f);
        const float z = std::max(std::abs(s[2]) - half_size[2], 0.f);
        kept_count += x * x + y * y + z * z <= squared_distance;  // else the next overwrites it
    }
    return kept_count;
}

LAPLACIAN_LINES_CLONES
void sum_gaussians(const GaussianTargets& t, const GaussianSource* sources,
                   std::size_t source_count, GaussianLaneSums& sums) {
    const Floats x = load(t.x), y = load(t.y), z = load(t.z);
    const Floats nx = load(t.nx), ny = load(t.ny), nz = load(t.nz);
    const Floats squared_cutoff = load(t.squared_cutoff), exponent = load(t.exponent);
    Floats mass{}, mx{}, my{}, mz{}, snx{}, sny{}, snz{};
    for (std::size_t i = 0; i < source_count; ++i) {
        const GaussianSource& s = sources[i];
        const Floats dx = s.x - x, dy = s.y - y, dz = s.z - z;
        const Floats squared = dx * dx + dy * dy + dz * dz;
        const Floats dnx = s.nx - nx, dny = s.ny - ny, dnz = s.nz - nz;
        const Floats squared_chord = dnx * dnx + dny * dny + dnz * dnz;
        const Floats facing = 1.f + t.facing * (facing_weight(1.f - 0.5f * squared_chord) - 1.f);
        const Floats g = exp2_of_negative(squared * exponent + t.normal_exponent * squared_chord) *
                         s.mass * facing;
        const Floats w = (Floats)((Ints)g & ~is_negative(squared_cutoff - squared));
        mass += w;
        mx += w * dx;
        my += w * dy;
        mz += w * dz;
        snx += w * dnx;
        sny += w * dny;
        snz += w * dnz;
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
