// SPDX-License-Identifier: GPL-3.0-or-later
#include "sums/simd_gaussian_sums.h"

#include "system/simd_sets.h"
#include "system/simd_vectors.h"

namespace laplacian_lines {
namespace SIMD_SET {

constexpr float kRound = 12582912.f;  // 1.5·2^23: adding it rounds to an integer
constexpr float kQuickFactor = 0.0780245226f, kQuickUnit = 8388608;  // 2^23

/// y · 2^n for `shifted` = n + kRound: its low bits hold n, which is added to the exponent field.
static inline Floats scaled(Floats y, Floats shifted) {
    return (Floats)((Ints)y + ((Ints)shifted << 23));
}

/// 2^x for x < 127, relative error 2e-7; tiny results become about 1e-37 instead of 0.
static inline Floats exp2_exactly(Floats x) {
    x = at_least(x, -124);
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

/// 2^x / kQuickFactor for an argument x · 2^23, |x| < 120; relative error 8e-5 of alternating sign.
/// Additions bound the sums, so x is split by a conversion.
static inline Floats quick_exp2(Floats x) {
    const Ints fixed = __builtin_convertvector(x, Ints);
    const Floats m = (Floats)((fixed & 0x7fffff) | 0x3f800000);  // 1 + the fraction
    // 2^(m − 1): the minimax polynomial of degree 3, divided by its first coefficient.
    const Floats y = ((m - 0.102614088f) * m + 6.12336733f) * m + 5.79477163f;
    return (Floats)((Ints)y + (fixed & ~0x7fffff));
}

static inline void sum(const GaussianTargets& t, const GaussianSource* sources,
                       std::size_t source_count, std::size_t lane, GaussianLaneSums& sums) {
    const Floats x = load(t.x + lane), y = load(t.y + lane), z = load(t.z + lane);
    const Floats nx = load(t.nx + lane), ny = load(t.ny + lane), nz = load(t.nz + lane);
    const Floats squared_cutoff = load(t.squared_cutoff + lane), exponent = load(t.exponent + lane);
    const float facing_factor = t.facing / 32;
    Floats mass{}, mx{}, my{}, mz{}, snx{}, sny{}, snz{};
    for (std::size_t i = 0; i < source_count; ++i) {
        const GaussianSource& s = sources[i];
        const Floats dx = s.x - x, dy = s.y - y, dz = s.z - z;
        const Floats squared = dx * dx + dy * dy + dz * dz;
        const Floats dnx = s.nx - nx, dny = s.ny - ny, dnz = s.nz - nz;
        const Floats squared_chord = dnx * dnx + dny * dny + dnz * dnz;
        // facing_weight() of the cosine 1 − chord²/2
        const Floats facing =
            1.f + (facing_factor * (squared_chord * squared_chord)) * (squared_chord - 6.f);
        const Floats g = exp2_exactly(squared * exponent + t.normal_exponent * squared_chord) *
                         (s.mass * facing);
        const Floats w = (Floats)((Ints)g & ~(squared > squared_cutoff));
        mass += w;
        mx += w * dx;
        my += w * dy;
        mz += w * dz;
        snx += w * dnx;
        sny += w * dny;
        snz += w * dnz;
    }
    store(sums.mass + lane, t.unit_mass * mass);
    store(sums.mx + lane, t.unit_mass * mx);
    store(sums.my + lane, t.unit_mass * my);
    store(sums.mz + lane, t.unit_mass * mz);
    store(sums.nx + lane, t.unit_mass * snx);
    store(sums.ny + lane, t.unit_mass * sny);
    store(sums.nz + lane, t.unit_mass * snz);
}

/// Sources whose weights are kept, so that registers hold either what these need or the sums.
constexpr std::size_t kTogether = 32;

// It sums q and n_q, from which the sums of q − p and n_q − n_p follow; the exponent −(|q − p|² −
// c²)/4h is multiplied out, and its sign says whether q is within the cutoff c. Errors of
// quick_exp2() depend on the distance alone, so they are the same all around p.
static inline void sum_quickly(const GaussianTargets& t, const GaussianSource* sources,
                               std::size_t source_count, std::size_t lane, GaussianLaneSums& sums) {
    const Floats px = load(t.x + lane), py = load(t.y + lane), pz = load(t.z + lane),
                 exponent = kQuickUnit * load(t.exponent + lane);
    const Floats x = -2.f * px * exponent, y = -2.f * py * exponent, z = -2.f * pz * exponent;
    const Floats constant_exponent =
        (px * px + py * py + pz * pz) * exponent - kQuickUnit * t.log2_cutoff;
    const float* mean = t.mean_normal;
    const Floats tx = load(t.nx + lane), ty = load(t.ny + lane), tz = load(t.nz + lane);
    // n_p, or 0, so that 1 + cosine is 2 at all sources.
    const Floats nx = t.facing * (tx + mean[0]), ny = t.facing * (ty + mean[1]),
                 nz = t.facing * (tz + mean[2]);
    const Floats mean_cosine = mean[0] * nx + mean[1] * ny + mean[2] * nz + (2 - t.facing);
    Floats mass{}, mx{}, my{}, mz{}, snx{}, sny{}, snz{};
    for (; source_count > 0; sources += kTogether) {
        const std::size_t some = source_count < kTogether ? source_count : kTogether;
        Floats w[kTogether];
        for (std::size_t i = 0; i < some; ++i) {
            const GaussianSource& s = sources[i];
            const Floats e =
                (s.squared * exponent + (s.x * x + constant_exponent)) + (s.z * z + s.y * y);
            const Floats cosine =
                (s.nx * nx + mean_cosine) + (s.nz * nz + s.ny * ny);   // 1 + cosine
            const Floats facing = (cosine * cosine) * (cosine - 3.f);  // −4 facing_weight()
            const Floats g = facing * (s.mass * quick_exp2(e));
            w[i] = (Floats)((Ints)g & (e >= 0));
        }
        for (std::size_t i = 0; i < some; ++i) {
            const GaussianSource& s = sources[i];
            mass += w[i];
            mx += w[i] * s.x;
            my += w[i] * s.y;
            mz += w[i] * s.z;
            snx += w[i] * s.nx;
            sny += w[i] * s.ny;
            snz += w[i] * s.nz;
        }
        source_count -= some;
    }
    const Floats scale =
        -0.25f * kQuickFactor * t.unit_mass * exp2_exactly(Floats{} + t.log2_cutoff);
    store(sums.mass + lane, scale * mass);
    store(sums.mx + lane, scale * (mx - mass * px));
    store(sums.my + lane, scale * (my - mass * py));
    store(sums.mz + lane, scale * (mz - mass * pz));
    store(sums.nx + lane, scale * (snx - mass * tx));
    store(sums.ny + lane, scale * (sny - mass * ty));
    store(sums.nz + lane, scale * (snz - mass * tz));
}

static void sum_all(const GaussianTargets& t, const GaussianSource* sources, std::size_t count,
                    GaussianLaneSums& sums) {
    for (std::size_t lane = 0; lane < kTargets; lane += kLanes)
        sum(t, sources, count, lane, sums);
}
static void sum_all_quickly(const GaussianTargets& t, const GaussianSource* sources,
                            std::size_t count, GaussianLaneSums& sums) {
    for (std::size_t lane = 0; lane < kTargets; lane += kLanes)
        sum_quickly(t, sources, count, lane, sums);
}

}  // namespace SIMD_SET

template <>
const GaussianLoops& functions_of<GaussianLoops, InstructionSet::SIMD_SET>() {
    using namespace SIMD_SET;
    static constexpr GaussianLoops functions = {sum_all, sum_all_quickly};
    return functions;
}

}  // namespace laplacian_lines
