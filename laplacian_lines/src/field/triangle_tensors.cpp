// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/triangle_tensors.h"

#include "system/simd_sets.h"
#include "system/simd_vectors.h"

namespace laplacian_lines {
namespace SIMD_SET {

using Vector = SpaceVectors<Doubles>;

static inline Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static inline Doubles length(const Vector& a) {
    return square_root(dot(a, a));
}

/// In the plane of a triangle with unit normal n: tt t tᵀ + tb (t bᵀ + b tᵀ) + bb b bᵀ.
struct PlaneTensor {
    Vector n, t, b;  // orthonormal
    Doubles tt, tb, bb;
};

static inline PlaneTensor fit(const Vector& n, const Doubles& twice_area, const Vector edges[3],
                              const Vector changes[3]) {
    PlaneTensor tensor;
    tensor.n = n;
    tensor.t = edges[0] * (1 / length(edges[0]));
    tensor.b = cross(n, tensor.t);
    Doubles uu{}, uv{}, vv{}, ru{}, rm{}, rv{};
    for (int k = 0; k < 3; ++k) {
        const Doubles u = dot(edges[k], tensor.t), v = dot(edges[k], tensor.b);
        const Doubles du = dot(changes[k], tensor.t), dv = dot(changes[k], tensor.b);
        uu += u * u, uv += u * v, vv += v * v;
        ru += du * u, rm += du * v + dv * u, rv += dv * v;
    }
    // Normal equations with the rows (uu, uv, 0), (uv, uu + vv, uv), (0, uv, vv), by cofactors.
    // uu·vv − uv² is the sum of the squared products of two edges: no cancellation in slivers.
    const Doubles squares = 3 * twice_area * twice_area;
    const Doubles scale = 1 / ((uu + vv) * squares);
    tensor.tt = scale * ((vv * vv + squares) * ru - uv * vv * rm + uv * uv * rv);
    tensor.tb = scale * (uu * vv * rm - uv * (vv * ru + uu * rv));
    tensor.bb = scale * ((uu * uu + squares) * rv - uv * uu * rm + uv * uv * ru);
    return tensor;
}

/// Writes `weight` times the tensor turned, with its plane, from its normal to m.
static inline void turn(const PlaneTensor& tensor, const Vector& m, const Doubles& weight, int lane,
                        double cosines[], double entries[][TriangleBatch::kSize]) {
    const Doubles cosine = dot(tensor.n, m);
    const Vector middle = (tensor.n + m) * (1 / (1 + cosine));
    const Vector t = tensor.t - middle * dot(tensor.t, m);
    const Vector b = tensor.b - middle * dot(tensor.b, m);
    const Vector p = t * (weight * tensor.tt) + b * (weight * tensor.tb);
    const Vector q = t * (weight * tensor.tb) + b * (weight * tensor.bb);
    store(cosines + lane, cosine);
    store(entries[TensorBatch::kXX] + lane, t.x * p.x + b.x * q.x);
    store(entries[TensorBatch::kYY] + lane, t.y * p.y + b.y * q.y);
    store(entries[TensorBatch::kZZ] + lane, t.z * p.z + b.z * q.z);
    store(entries[TensorBatch::kYZ] + lane, t.y * p.z + b.y * q.z);
    store(entries[TensorBatch::kXZ] + lane, t.x * p.z + b.x * q.z);
    store(entries[TensorBatch::kXY] + lane, t.x * p.y + b.x * q.y);
}

static inline void fit_some(const TriangleBatch& triangles, int lane, TensorBatch& result) {
    Vector p[3], n[3];
    for (int k = 0; k < 3; ++k)
        p[k] = load_vectors(triangles.positions[k], lane),
        n[k] = load_vectors(triangles.normals[k], lane);
    const Vector edges[3] = {p[2] - p[1], p[0] - p[2], p[1] - p[0]};
    const Vector changes[3] = {n[2] - n[1], n[0] - n[2], n[1] - n[0]};
    const Vector area = cross(edges[2], p[2] - p[0]);
    const Doubles twice_area = length(area);
    const PlaneTensor tensor = fit(area * (1 / twice_area), twice_area, edges, changes);
    store(result.weights + lane, twice_area);
    store(result.sums + lane, tensor.tt + tensor.tb + tensor.bb);
    for (int k = 0; k < 3; ++k)
        turn(tensor, n[k], twice_area, lane, result.cosines[k], result.tensors[k]);
}

static inline void fit_all(const TriangleBatch& triangles, TensorBatch& result) {
    for (int lane = 0; lane < TriangleBatch::kSize; lane += int(kLanes / 2))
        fit_some(triangles, lane, result);
}

}  // namespace SIMD_SET

template <>
const TensorLoops& functions_of<TensorLoops, InstructionSet::SIMD_SET>() {
    static constexpr TensorLoops functions = {SIMD_SET::fit_all};
    return functions;
}

}  // namespace laplacian_lines
