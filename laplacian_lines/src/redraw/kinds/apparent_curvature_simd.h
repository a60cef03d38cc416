// SPDX-License-Identifier: GPL-3.0-or-later
// The view-dependent curvature q1 at vertices, of T. Judd, F. Durand, E. Adelson, "Apparent Ridges
// for Line Drawing" (2007), its direction and its derivative along that.
#pragma once

#include "redraw/simd/simd_batch.h"
#include "redraw/simd/simd_columns.h"

namespace laplacian_lines {
namespace SIMD_SET {

/// q1, D and r at vertices; q1 = 0 where they face away or have no direction.
struct ApparentCurvature {
    Floats q, derivative;
    Vectors direction;
};

/// The vector to the eye of unit length, by its cosine with the normal and its tangential part w;
/// and how vectors on the screen lie in the tangent plane, A = P⁻¹ = 1 + k w wᵀ: longer by 1/cosine
/// along w.
struct Sight {
    Floats per_distance, cosine, k;
    Tangents w;

    Sight(const CurvatureColumns& p, const float eye[4]) {
        const Vectors e = {Floats{} + eye[0], Floats{} + eye[1], Floats{} + eye[2]};
        const Vectors v = e - p.position * (Floats{} + eye[3]);
        const Floats distance = square_root(dot(v, v));
        per_distance = eye[3] / distance;
        const Vectors unit = v * (1 / distance);
        cosine = dot(p.normal, unit);
        w = p.tangent(unit);
        k = 1 / (cosine * (1 + cosine));
    }

    Tangents to_surface(const Tangents& screen) const { return screen + w * (k * dot(w, screen)); }
    Tangents u_to_surface() const { return {1 + k * w.u * w.u, k * w.u * w.v}; }
    Tangents v_to_surface() const { return {k * w.u * w.v, 1 + k * w.v * w.v}; }

    /// x·(dA t) for tangents x and t, dA the change of A along r.
    Floats change(const CurvatureColumns& p, const Tangents& r, const Tangents& x,
                  const Tangents& t) const {
        const Tangents sr = p.S(r);
        const Floats wr = dot(w, r);
        const Floats d_cosine = dot(sr, w) + per_distance * cosine * wr;
        const Tangents dw = (r - w * wr) * (-per_distance) - sr * cosine;
        const Floats wx = dot(w, x), wt = dot(w, t);
        return k * (dot(dw, x) * wt + wx * dot(dw, t)) -
               k * k * (1 + 2 * cosine) * d_cosine * wx * wt;
    }
};

static inline Floats choose(Ints condition, Floats a, Floats b) {
    return condition ? a : b;
}

/// q1² is the larger eigenvalue of (S A)ᵀ S A, t its direction, r that of A t; the derivative of an
/// eigenvalue is that of the matrix between its directions: 2 q1 D = 2 (S b·dA t + C(r, a, b)) with
/// a = A t, b = S a.
static inline ApparentCurvature apparent_curvature(const CurvatureColumns& p, const Sight& sight) {
    const Tangents su = p.S(sight.u_to_surface()), sv = p.S(sight.v_to_surface());
    const Floats uu = dot(su, su), uv = dot(su, sv), vv = dot(sv, sv);
    const Floats half = (uu - vv) / 2, root = square_root(half * half + uv * uv);
    const Floats squared = (uu + vv) / 2 + root, q = square_root(squared);
    const Ints along_u = half > 0;
    const Floats absolute_half = choose(along_u, half, -half);
    const Floats tu = choose(along_u, absolute_half + root, uv),
                 tv = choose(along_u, uv, absolute_half + root);
    const Floats length = square_root(tu * tu + tv * tv);
    const Tangents t = {tu / length, tv / length};
    const Tangents a = sight.to_surface(t), b = p.S(a);
    const Tangents r = a * (1 / square_root(dot(a, a)));
    const Floats derivative = (sight.change(p, r, p.S(b), t) + p.C(r, a, b)) / q;
    const Ints usable = (sight.cosine > 0) & (length > 0);
    return {choose(usable, q, Floats{}), derivative, p.in_space(r)};
}

static inline void evaluate_apparent(const ClusterInSlot& place, const float eye[4],
                                     ApparentMemory& m) {
    const unsigned first = place.slot * kClusterVertices, count = place.cluster.vertex_count;
    for (unsigned i = 0; i < count; i += kLanes) {
        const CurvatureColumns p(curvatures_of(place), i, count);
        const Sight sight(p, eye);
        if (bits_of(sight.cosine > 0) == 0) {
            store(m.q + first + i, Floats{});
            continue;
        }
        const ApparentCurvature c = apparent_curvature(p, sight);
        store(m.q + first + i, c.q);
        Floats columns[4] = {c.direction.x, c.direction.y, c.direction.z, c.derivative};
        store_as_rows(columns, [&](unsigned lane) { return m.vectors[first + i + lane]; });
    }
}

}  // namespace SIMD_SET
}  // namespace laplacian_lines
