// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over the neighbours q of a vertex p for tensor_fits.cpp, several vertices at a time. With x
// and y the place of q in p's tangent plane and d its distance, in radii, and the weight
// w = 4 m max(1 − d², 0)² facing_weight() (gaussian_sums.h), whose 4 cancels in a fit, they are
// Σ w, Σ w (x, y), Σ w (x², x y, y²), and of the tensor S: Σ w S, Σ w x S, Σ w y S.
#include "field/tensor_sums.h"

#include "system/simd_sets.h"
#include "system/simd_vectors.h"

namespace laplacian_lines {
namespace SIMD_SET {

using Vector = SpaceVectors<Floats>;
struct Tensors {
    Floats xx{}, yy{}, zz{}, yz{}, xz{}, xy{};
};

static inline void add_weighted(const TensorSource* sources, const Floats* weights,
                                std::size_t count, Tensors& result) {
    Tensors sums = result;  // in registers
    for (std::size_t i = 0; i < count; ++i) {
        const TensorSource& s = sources[i];
        const Floats weight = weights[i];
        sums.xx += s.xx * weight, sums.yy += s.yy * weight, sums.zz += s.zz * weight;
        sums.yz += s.yz * weight, sums.xz += s.xz * weight, sums.xy += s.xy * weight;
    }
    result = sums;
}

static inline Vector times(const Tensors& s, const Vector& a) {
    return {s.xx * a.x + s.xy * a.y + s.xz * a.z, s.xy * a.x + s.yy * a.y + s.yz * a.z,
            s.xz * a.x + s.yz * a.y + s.zz * a.z};
}

/// S(u,u), S(u,v) and S(v,v).
static inline void store(float (*p)[kTensorLanes], std::size_t lane, const Tensors& s,
                         const Vector& u, const Vector& v) {
    const Vector su = times(s, u), sv = times(s, v);
    store(p[0] + lane, dot(su, u));
    store(p[1] + lane, dot(su, v));
    store(p[2] + lane, dot(sv, v));
}

/// Vertices to sum at, in a vector's lanes; `place` in radii.
struct LaneTargets {
    Vector normal, u, v, place;
    float per_radius;
};
static inline LaneTargets lane_targets(const TensorTargets& t, std::size_t lane) {
    return {load_vectors(t.normal, lane), load_vectors(t.u, lane), load_vectors(t.v, lane),
            load_vectors(t.position, lane) * (Floats{} + t.per_radius), t.per_radius};
}

/// A source seen from the targets.
struct Seen {
    Floats weight, x, y;
};
/// 4 facing_weight() = (1 + cosine)² (3 − (1 + cosine)).
static inline Seen see(const LaneTargets& t, const TensorSource& s) {
    const Vector d = {s.x * t.per_radius - t.place.x, s.y * t.per_radius - t.place.y,
                      s.z * t.per_radius - t.place.z};
    const Floats inside = at_least(1 - d.x * d.x - d.y * d.y - d.z * d.z, 0);
    // 1 + cosine, the constant first, so that it joins a multiplication
    const Floats facing =
        s.normal[2] * t.normal.z + (s.normal[1] * t.normal.y + (s.normal[0] * t.normal.x + 1.f));
    const Floats root = inside * facing;
    return {(s.mass * (3 - facing)) * (root * root), dot(d, t.u), dot(d, t.v)};
}

/// Sources whose weights are kept, so that registers hold either what these need or some sums.
constexpr std::size_t kTogether = 32;

// Multiplications bound the time, so tensors are summed in space and projected at the end.
static inline void sum(const TensorTargets& targets, const TensorSource* sources, std::size_t count,
                       std::size_t lane, TensorSums& sums) {
    using Sums = TensorSums;
    const LaneTargets t = lane_targets(targets, lane);
    Floats weight{}, x_sum{}, y_sum{}, xx{}, xy{}, yy{};
    Tensors s_sum, xs_sum, ys_sum;
    for (std::size_t some; count > 0; sources += some, count -= some) {
        some = count < kTogether ? count : kTogether;
        Floats w[kTogether], wx[kTogether], wy[kTogether];
        for (std::size_t i = 0; i < some; ++i) {
            const Seen seen = see(t, sources[i]);
            w[i] = seen.weight;
            wx[i] = w[i] * seen.x, wy[i] = w[i] * seen.y;
            weight += w[i], x_sum += wx[i], y_sum += wy[i];
            xx += wx[i] * seen.x, xy += wx[i] * seen.y, yy += wy[i] * seen.y;
        }
        add_weighted(sources, w, some, s_sum);
        add_weighted(sources, wx, some, xs_sum);
        add_weighted(sources, wy, some, ys_sum);
    }
    store(sums.numbers[Sums::kWeight] + lane, weight);
    store(sums.numbers[Sums::kX] + lane, x_sum);
    store(sums.numbers[Sums::kY] + lane, y_sum);
    store(sums.numbers[Sums::kXX] + lane, xx);
    store(sums.numbers[Sums::kXY] + lane, xy);
    store(sums.numbers[Sums::kYY] + lane, yy);
    store(&sums.numbers[Sums::kEntries], lane, s_sum, t.u, t.v);
    store(&sums.numbers[Sums::kXEntries], lane, xs_sum, t.u, t.v);
    store(&sums.numbers[Sums::kYEntries], lane, ys_sum, t.u, t.v);
}

}  // namespace SIMD_SET

template <>
const TensorLoops& functions_of<TensorLoops, InstructionSet::SIMD_SET>() {
    using namespace SIMD_SET;
    static constexpr TensorLoops functions = {at_all_lanes<sum, kTensorLanes>};
    return functions;
}

}  // namespace laplacian_lines
