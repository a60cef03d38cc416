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

constexpr float kRound = 12582912.f;  // 1.5·2^23: adding it rounds to an integer

/// Times 2^n of `shifted` = n + kRound: the integer sits in the low bits, to be added to the
/// exponent field.
LAPLACIAN_LINES_INLINE Floats scaled(Floats y, Floats shifted) {
    return (Floats)((Ints)y + ((Ints)shifted << 23));
}

/// 2^x for x <= 0, relative error 2e-7; tiny results become about 1e-37 instead of 0.
LAPLACIAN_LINES_INLINE Floats exp2_of_negative(Floats x) {
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
    return scaled(y, shifted);
}

/// 2^x for −126 < x <= 0, relative error 4e-5 of changing sign; anything for other x.
LAPLACIAN_LINES_INLINE Floats quick_exp2(Floats x) {
    const Floats shifted = x + kRound;
    const Floats f = x - (shifted - kRound);
    Floats y = 9.6181291e-3f * f + 5.5504109e-2f;
    y = y * f + 2.4022651e-1f;
    y = y * f + 6.9314718e-1f;
    y = y * f + 1.f;
    return scaled(y, shifted);
}

/// max(|v| − half, 0)
LAPLACIAN_LINES_INLINE Floats beyond(Floats v, float half) {
    const Floats size = (Floats)((Ints)v & 0x7fffffff) - half;
    return (Floats)((Ints)size & ~is_negative(size));
}

}  // namespace

LAPLACIAN_LINES_CLONES
std::size_t collect_sources(const SourceLeaf& leaf, std::size_t count, const GaussianSource& shift,
                            const float half_size[3], float squared_distance,
                            GaussianSource* kept) {
    // −1 for a source that is kept, else 0.
    alignas(64) std::int32_t keep[SourceLeaf::kSize];
    for (std::size_t i = 0; i < SourceLeaf::kSize; i += kLanes) {
        const Floats x = beyond(load(leaf.x + i) + shift.x, half_size[0]);
        const Floats y = beyond(load(leaf.y + i) + shift.y, half_size[1]);
        const Floats z = beyond(load(leaf.z + i) + shift.z, half_size[2]);
        *reinterpret_cast<Ints*>(keep + i) =
            ~is_negative(squared_distance - (x * x + y * y + z * z));
    }
    typedef float Source __attribute__((vector_size(sizeof(GaussianSource))));
    const Source by = *reinterpret_cast<const Source*>(&shift);
    std::size_t kept_count = 0;
    for (std::size_t i = 0; i < count; ++i) {
        *reinterpret_cast<Source*>(&kept[kept_count]) =
            *reinterpret_cast<const Source*>(&leaf.sources[i]) + by;
        kept_count -= std::size_t(std::ptrdiff_t(keep[i]));  // else the next overwrites it
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

LAPLACIAN_LINES_CLONES
void sum_quickly(const GaussianTargets& t, const GaussianSource* sources, std::size_t source_count,
                 GaussianLaneSums& sums) {
    const Floats x = load(t.x), y = load(t.y), z = load(t.z);
    const float* mean = t.mean_normal;
    const Floats nx = load(t.nx) + mean[0], ny = load(t.ny) + mean[1], nz = load(t.nz) + mean[2];
    const Floats mean_cosine = mean[0] * nx + mean[1] * ny + mean[2] * nz;
    const Floats squared_cutoff = load(t.squared_cutoff), exponent = load(t.exponent);
    // facing_weight(c) multiplied out, or 1: constant + c (linear + cubic c²).
    const float constant = 1 - 0.5f * t.facing, linear = 0.75f * t.facing,
                cubic = -0.25f * t.facing;
    Floats mass{}, mx{}, my{}, mz{}, snx{}, sny{}, snz{};
    for (std::size_t i = 0; i < source_count; ++i) {
        const GaussianSource& s = sources[i];
        const Floats dx = s.x - x, dy = s.y - y, dz = s.z - z;
        const Floats squared = dx * dx + dy * dy + dz * dz;
        const Floats cosine = mean_cosine + s.nx * nx + s.ny * ny + s.nz * nz;
        const Floats facing = constant + cosine * (linear + cubic * (cosine * cosine));
        const Floats g = (s.mass * facing) * quick_exp2(squared * exponent);
        const Floats w = (Floats)((Ints)g & ~is_negative(squared_cutoff - squared));
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
    store(sums.nx, snx - mass * load(t.nx));
    store(sums.ny, sny - mass * load(t.ny));
    store(sums.nz, snz - mass * load(t.nz));
}

}  // namespace laplacian_lines
