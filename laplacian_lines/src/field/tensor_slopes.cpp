// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/tensor_slopes.h"

#include <cstdint>

#include "sums/facing_weight.h"
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
LAPLACIAN_LINES_INLINE Vector times(const TensorSource& s, const Vector& a) {
    return {s.xx * a.x + s.xy * a.y + s.xz * a.z, s.xy * a.x + s.yy * a.y + s.yz * a.z,
            s.xz * a.x + s.yz * a.y + s.zz * a.z};
}
/// Where negative, 0. Comparisons of vectors would be lowered to scalar code before the function is
/// cloned; shifts are not.
LAPLACIAN_LINES_INLINE Floats positive(Floats v) {
    return (Floats)((Ints)v & ~((Ints)v >> 31));
}

}  // namespace

LAPLACIAN_LINES_CLONES
void sum_tensors(const TensorTargets& targets, const TensorSource* sources, std::size_t count,
                 TensorSums& sums) {
    using Sums = TensorSums;
    const Vector p = load(targets.position), m = load(targets.normal);
    const Vector u = load(targets.u), v = load(targets.v);
    const Floats per_radius = load(targets.per_radius);
    Floats total[Sums::kNumbers] = {};
    for (const TensorSource* s = sources; s < sources + count; ++s) {
        const Vector d = {(s->x - p.x) * per_radius, (s->y - p.y) * per_radius,
                          (s->z - p.z) * per_radius};
        const Floats inside = positive(1 - dot(d, d));
        const Floats cosine = s->normal[0] * m.x + s->normal[1] * m.y + s->normal[2] * m.z;
        const Floats w = s->mass * (inside * inside) * facing_weight(cosine);
        const Floats x = dot(d, u), y = dot(d, v), wx = w * x, wy = w * y;
        const Vector su = times(*s, u), sv = times(*s, v);
        const Floats entries[3] = {dot(su, u), dot(su, v), dot(sv, v)};
        total[Sums::kWeight] += w;
        total[Sums::kX] += wx;
        total[Sums::kY] += wy;
        total[Sums::kXX] += wx * x;
        total[Sums::kXY] += wx * y;
        total[Sums::kYY] += wy * y;
        for (int i = 0; i < 3; ++i) {
            total[Sums::kEntries + i] += w * entries[i];
            total[Sums::kXEntries + i] += wx * entries[i];
            total[Sums::kYEntries + i] += wy * entries[i];
        }
    }
    for (int i = 0; i < Sums::kNumbers; ++i)
        *reinterpret_cast<Floats*>(sums.numbers[i]) = total[i];
}

}  // namespace laplacian_lines
