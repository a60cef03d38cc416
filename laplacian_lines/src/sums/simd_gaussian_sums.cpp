// SPDX-License-Identifier: GPL-3.0-or-later
// Σ w, Σ w (q − p) and Σ w (n_q − n_p) over sources q, with the Gaussian weight w = m(q)
// 2^(exponent |q − p|²) facing_weight(n_q·n_p), for a target p in each lane of a vector:
//  - sum(): as written here.
//  - sum_quickly(), about twice as fast: powers of 2 less exact, and differences from p taken after
//    the sums, Σ w q − p Σ w.
#include "sums/simd_gaussian_sums.h"

#include "system/simd_sets.h"
#include "system/simd_vectors.h"

namespace laplacian_lines {
namespace SIMD_SET {

using Vector = SpaceVectors<Floats>;

constexpr float kRound = 12582912.f;  // 1.5·2^23: adding it rounds to an integer
constexpr float kQuickFactor = 0.0780245226f, kQuickUnit = 8388608;  // 2^23

/// y · 2^n for `shifted` = n + kRound: its low bits hold n, which is added to the exponent field.
static inline Floats scaled(Floats y, Floats shifted) {
    return (Floats)((Ints)y + ((Ints)shifted << 23));
}

/// 2^x for x < 127, relative error 2.5e-7; tiny results become 2^-124 instead of 0.
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
/// Additions limit the speed of the sums, so x is split by a conversion.
static inline Floats quick_exp2(Floats x) {
    const Ints fixed = __builtin_convertvector(x, Ints);
    const Floats m = (Floats)((fixed & 0x7fffff) | 0x3f800000);  // 1 + the fraction
    // 2^(m − 1): the minimax polynomial of degree 3, divided by its first coefficient.
    const Floats y = ((m - 0.102614088f) * m + 6.12336733f) * m + 5.79477163f;
    return (Floats)((Ints)y + (fixed & ~0x7fffff));
}

/// Weighted sums at a vector of targets.
struct LaneSums {
    Floats mass{};
    Vector moment{}, normal{};
};

static inline void store(const LaneSums& s, Floats scale, std::size_t lane, GaussianLaneSums& to) {
    store(to.mass + lane, s.mass * scale);
    store_vectors(s.moment * scale, to.moment, lane);
    store_vectors(s.normal * scale, to.normal, lane);
}

static inline void sum(const GaussianTargets& t, const GaussianSource* sources,
                       std::size_t source_count, std::size_t lane, GaussianLaneSums& result) {
    const Vector p = load_vectors(t.position, lane), n = load_vectors(t.normal, lane);
    const float facing_factor = t.facing / 32;
    LaneSums sums;
    for (std::size_t i = 0; i < source_count; ++i) {
        const GaussianSource& s = sources[i];
        const Vector d = {s.x - p.x, s.y - p.y, s.z - p.z};
        const Vector chord = {s.nx - n.x, s.ny - n.y, s.nz - n.z};
        const Floats squared = dot(d, d), squared_chord = dot(chord, chord);
        // facing_weight() of the cosine 1 − chord²/2
        const Floats facing =
            1.f + (facing_factor * (squared_chord * squared_chord)) * (squared_chord - 6.f);
        const Floats g = exp2_exactly(squared * t.exponent) * (s.mass * facing);
        const Floats w = (Floats)((Ints)g & ~(squared > t.squared_cutoff));
        sums.mass += w;
        sums.moment = sums.moment + d * w;
        sums.normal = sums.normal + chord * w;
    }
    store(sums, Floats{} + t.unit_mass, lane, result);
}

/// The targets of sum_quickly(), prepared so that a source's weight takes the fewest operations.
struct QuickTargets {
    Floats exponent, x, y, z, constant_exponent;  ///< the exponent is linear in |q|², q and 1
    Floats nx, ny, nz, constant_cosine;           ///< 1 + n_q·n_p is linear in n_q and 1
};

/// The exponent −(|q − p|² − c²)/4h is multiplied out; its sign says if q is within the cutoff c.
static inline QuickTargets quick_targets(const GaussianTargets& t, std::size_t lane) {
    QuickTargets q;
    const Vector p = load_vectors(t.position, lane), n = load_vectors(t.normal, lane);
    q.exponent = Floats{} + kQuickUnit * t.exponent;
    q.x = -2.f * p.x * q.exponent;
    q.y = -2.f * p.y * q.exponent;
    q.z = -2.f * p.z * q.exponent;
    q.constant_exponent = dot(p, p) * q.exponent - kQuickUnit * t.log2_cutoff;
    // n_p, or 0, so that 1 + cosine is 2 at all sources.
    const float* mean = t.mean_normal;
    q.nx = t.facing * (n.x + mean[0]);
    q.ny = t.facing * (n.y + mean[1]);
    q.nz = t.facing * (n.z + mean[2]);
    q.constant_cosine = mean[0] * q.nx + mean[1] * q.ny + mean[2] * q.nz + (2 - t.facing);
    return q;
}

/// Up to a factor of all weights. Errors of quick_exp2() depend on the distance alone, so they are
/// the same all around p.
static inline Floats quick_weight(const QuickTargets& t, const GaussianSource& s) {
    const Floats e =
        (s.squared * t.exponent + (s.x * t.x + t.constant_exponent)) + (s.z * t.z + s.y * t.y);
    const Floats cosine =
        (s.nx * t.nx + t.constant_cosine) + (s.nz * t.nz + s.ny * t.ny);  // 1 + cosine
    const Floats facing = (cosine * cosine) * (cosine - 3.f);             // −4 facing_weight()
    const Floats g = facing * (s.mass * quick_exp2(e));
    return (Floats)((Ints)g & (e >= 0));
}

/// Sources whose weights are kept, so that registers hold either what these need or the sums.
constexpr std::size_t kTogether = 32;

static inline void sum_quickly(const GaussianTargets& t, const GaussianSource* sources,
                               std::size_t source_count, std::size_t lane,
                               GaussianLaneSums& result) {
    const QuickTargets quick = quick_targets(t, lane);
    LaneSums sums;
    for (std::size_t some; source_count > 0; sources += some, source_count -= some) {
        some = source_count < kTogether ? source_count : kTogether;
        Floats w[kTogether];
        for (std::size_t i = 0; i < some; ++i)
            w[i] = quick_weight(quick, sources[i]);
        for (std::size_t i = 0; i < some; ++i) {
            const GaussianSource& s = sources[i];
            sums.mass += w[i];
            sums.moment = sums.moment + Vector{w[i] * s.x, w[i] * s.y, w[i] * s.z};
            sums.normal = sums.normal + Vector{w[i] * s.nx, w[i] * s.ny, w[i] * s.nz};
        }
    }
    sums.moment = sums.moment - load_vectors(t.position, lane) * sums.mass;
    sums.normal = sums.normal - load_vectors(t.normal, lane) * sums.mass;
    // What quick_weight() left out.
    const Floats scale =
        -0.25f * kQuickFactor * t.unit_mass * exp2_exactly(Floats{} + t.log2_cutoff);
    store(sums, scale, lane, result);
}

}  // namespace SIMD_SET

template <>
const GaussianLoops& functions_of<GaussianLoops, InstructionSet::SIMD_SET>() {
    using namespace SIMD_SET;
    static constexpr GaussianLoops functions = {at_all_lanes<sum, kTargets>,
                                                at_all_lanes<sum_quickly, kTargets>};
    return functions;
}

}  // namespace laplacian_lines
