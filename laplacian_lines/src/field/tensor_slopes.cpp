// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/tensor_slopes.h"

#include <cstdint>

#include "system/simd_clones.h"

namespace laplacian_lines {
namespace {

typedef float Floats __attribute__((vector_size(4 * kSlopeLanes)));
typedef std::int32_t Ints __attribute__((vector_size(4 * kSlopeLanes)));

LAPLACIAN_LINES_INLINE Floats load(const float* p) {
    return *reinterpret_cast<const Floats*>(p);
}

struct Vector {
    Floats x, y, z;
};
LAPLACIAN_LINES_INLINE Vector load(const float p[3][kSlopeLanes]) {
    return {load(p[0]), load(p[1]), load(p[2])};
}
LAPLACIAN_LINES_INLINE Floats dot(const Vector& a, const Vector& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// Where negative, 0. Comparisons of vectors would be lowered to scalar code before the function is
/// cloned; shifts are not.
LAPLACIAN_LINES_INLINE Floats positive(Floats v) {
    return (Floats)((Ints)v & ~((Ints)v >> 31));
}

/// Weighted sums of S over the sources.
struct Tensors {
    Floats xx{}, yy{}, zz{}, yz{}, xz{}, xy{};
};
LAPLACIAN_LINES_INLINE void add(const TensorSource& s, const Floats& weight, Tensors& sums) {
    sums.xx += s.xx * weight, sums.yy += s.yy * weight, sums.zz += s.zz * weight;
    sums.yz += s.yz * weight, sums.xz += s.xz * weight, sums.xy += s.xy * weight;
}
LAPLACIAN_LINES_INLINE Vector times(const Tensors& s, const Vector& a) {
    return {s.xx * a.x + s.xy * a.y + s.xz * a.z, s.xy * a.x + s.yy * a.y + s.yz * a.z,
            s.xz * a.x + s.yz * a.y + s.zz * a.z};
}

LAPLACIAN_LINES_INLINE void store(float* p, const Floats& v) {
    *reinterpret_cast<Floats*>(p) = 0.25f * v;
}
/// The three entries of a tensor in the plane of u and v.
LAPLACIAN_LINES_INLINE void store(float (*p)[kSlopeLanes], const Tensors& s, const Vector& u,
                                  const Vector& v) {
    const Vector su = times(s, u), sv = times(s, v);
    store(p[0], dot(su, u));
    store(p[1], dot(su, v));
    store(p[2], dot(sv, v));
}

/// max(|v| − half, 0)
LAPLACIAN_LINES_INLINE Floats beyond(Floats v, float half) {
    return positive((Floats)((Ints)v & 0x7fffffff) - half);
}

}  // namespace

LAPLACIAN_LINES_CLONES
std::size_t collect_tensors(const TensorLeaf& leaf, const float shift[3], const float half_size[3],
                            float squared_reach, TensorSource* kept) {
    alignas(64) std::int32_t keep[TensorLeaf::kSize];  // −1 for a source that is kept, else 0
    for (std::size_t i = 0; i < leaf.count; i += kSlopeLanes) {
        const Floats x = beyond(load(leaf.x + i) + shift[0], half_size[0]),
                     y = beyond(load(leaf.y + i) + shift[1], half_size[1]),
                     z = beyond(load(leaf.z + i) + shift[2], half_size[2]);
        *reinterpret_cast<Ints*>(keep + i) = (Ints)(x * x + y * y + z * z - squared_reach) >> 31;
    }
    const Floats by = {shift[0], shift[1], shift[2]};
    std::size_t count = 0;
    for (std::size_t i = 0; i < leaf.count; ++i) {
        *reinterpret_cast<Floats*>(&kept[count]) =
            *reinterpret_cast<const Floats*>(&leaf.sources[i]) + by;
        count -= std::size_t(std::ptrdiff_t(keep[i]));  // else the next overwrites it
    }
    return count;
}

// What bounds this loop are its multiplications. Tensors are summed as they are in space and put
// into the plane at the end; weights are 4 facing_weight(), which storing makes up for.
LAPLACIAN_LINES_CLONES
void sum_tensors(const TensorTargets& targets, const TensorSource* sources, std::size_t count,
                 TensorSums& sums) {
    using Sums = TensorSums;
    const Vector m = load(targets.normal), u = load(targets.u), v = load(targets.v);
    const Floats r = load(targets.per_radius);
    const Vector at = load(targets.position), p = {r * at.x, r * at.y, r * at.z};
    Floats weight{}, x_sum{}, y_sum{}, xx{}, xy{}, yy{};
    Tensors s_sum, xs_sum, ys_sum;
    for (const TensorSource* s = sources; s < sources + count; ++s) {
        const Vector d = {s->x * r - p.x, s->y * r - p.y, s->z * r - p.z};
        const Floats inside = positive(1 - d.x * d.x - d.y * d.y - d.z * d.z);
        // 1 + cosine
        const Floats facing =
            s->normal[2] * m.z + (s->normal[1] * m.y + (s->normal[0] * m.x + 1.f));
        const Floats root = inside * facing;
        const Floats w = (s->mass * (3 - facing)) * (root * root);
        const Floats x = dot(d, u), y = dot(d, v), wx = w * x, wy = w * y;
        weight += w;
        x_sum += wx;
        y_sum += wy;
        xx += wx * x;
        xy += wx * y;
        yy += wy * y;
        add(*s, w, s_sum);
        add(*s, wx, xs_sum);
        add(*s, wy, ys_sum);
    }
    store(sums.numbers[Sums::kWeight], weight);
    store(sums.numbers[Sums::kX], x_sum);
    store(sums.numbers[Sums::kY], y_sum);
    store(sums.numbers[Sums::kXX], xx);
    store(sums.numbers[Sums::kXY], xy);
    store(sums.numbers[Sums::kYY], yy);
    store(&sums.numbers[Sums::kEntries], s_sum, u, v);
    store(&sums.numbers[Sums::kXEntries], xs_sum, u, v);
    store(&sums.numbers[Sums::kYEntries], ys_sum, u, v);
}

}  // namespace laplacian_lines
