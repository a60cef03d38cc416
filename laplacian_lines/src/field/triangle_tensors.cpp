// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/triangle_tensors.h"

#include <cmath>

#include "system/simd_clones.h"

namespace laplacian_lines {
namespace {

typedef double Lanes __attribute__((vector_size(8 * TriangleBatch::kSize)));

struct Vector {
    Lanes x, y, z;
};

LAPLACIAN_LINES_INLINE Vector operator+(const Vector& a, const Vector& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
LAPLACIAN_LINES_INLINE Vector operator-(const Vector& a, const Vector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
LAPLACIAN_LINES_INLINE Vector operator*(const Lanes& s, const Vector& a) {
    return {s * a.x, s * a.y, s * a.z};
}
LAPLACIAN_LINES_INLINE Lanes dot(const Vector& a, const Vector& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
LAPLACIAN_LINES_INLINE Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
LAPLACIAN_LINES_INLINE Lanes length(const Vector& a) {
    alignas(sizeof(Lanes)) double lanes[TriangleBatch::kSize];
    *reinterpret_cast<Lanes*>(lanes) = dot(a, a);
    for (double& lane : lanes)
        lane = std::sqrt(lane);
    return *reinterpret_cast<const Lanes*>(lanes);
}

LAPLACIAN_LINES_INLINE const Lanes& load(const double* values) {
    return *reinterpret_cast<const Lanes*>(values);
}
LAPLACIAN_LINES_INLINE Vector load(const double values[3][TriangleBatch::kSize]) {
    return {load(values[0]), load(values[1]), load(values[2])};
}
LAPLACIAN_LINES_INLINE void store(double* values, const Lanes& v) {
    *reinterpret_cast<Lanes*>(values) = v;
}

/// In the plane of a triangle with unit normal n: tt t tᵀ + tb (t bᵀ + b tᵀ) + bb b bᵀ.
struct PlaneTensor {
    Vector n, t, b;  // orthonormal
    Lanes tt, tb, bb;
};

LAPLACIAN_LINES_INLINE PlaneTensor fit(const Vector& n, const Lanes& twice_area,
                                       const Vector edges[3], const Vector changes[3]) {
    PlaneTensor tensor;
    tensor.n = n;
    tensor.t = (1 / length(edges[0])) * edges[0];
    tensor.b = cross(n, tensor.t);
    Lanes uu{}, uv{}, vv{}, ru{}, rm{}, rv{};
    for (int k = 0; k < 3; ++k) {
        const Lanes u = dot(edges[k], tensor.t), v = dot(edges[k], tensor.b);
        const Lanes du = dot(changes[k], tensor.t), dv = dot(changes[k], tensor.b);
        uu += u * u, uv += u * v, vv += v * v;
        ru += du * u, rm += du * v + dv * u, rv += dv * v;
    }
    // Normal equations with the rows (uu, uv, 0), (uv, uu + vv, uv), (0, uv, vv), by cofactors.
    // uu·vv − uv² is the sum of the squared products of two edges: no cancellation in slivers.
    const Lanes squares = 3 * twice_area * twice_area;
    const Lanes scale = 1 / ((uu + vv) * squares);
    tensor.tt = scale * ((vv * vv + squares) * ru - uv * vv * rm + uv * uv * rv);
    tensor.tb = scale * (uu * vv * rm - uv * (vv * ru + uu * rv));
    tensor.bb = scale * ((uu * uu + squares) * rv - uv * uu * rm + uv * uv * ru);
    return tensor;
}

/// Writes `weight` times the tensor turned, with its plane, from its normal to m.
LAPLACIAN_LINES_INLINE void turn(const PlaneTensor& tensor, const Vector& m, const Lanes& weight,
                                 double cosines[], double entries[][TriangleBatch::kSize]) {
    const Lanes cosine = dot(tensor.n, m);
    const Vector middle = (1 / (1 + cosine)) * (tensor.n + m);
    const Vector t = tensor.t - dot(tensor.t, m) * middle;
    const Vector b = tensor.b - dot(tensor.b, m) * middle;
    const Vector p = (weight * tensor.tt) * t + (weight * tensor.tb) * b;
    const Vector q = (weight * tensor.tb) * t + (weight * tensor.bb) * b;
    store(cosines, cosine);
    store(entries[TensorBatch::kXX], t.x * p.x + b.x * q.x);
    store(entries[TensorBatch::kYY], t.y * p.y + b.y * q.y);
    store(entries[TensorBatch::kZZ], t.z * p.z + b.z * q.z);
    store(entries[TensorBatch::kYZ], t.y * p.z + b.y * q.z);
    store(entries[TensorBatch::kXZ], t.x * p.z + b.x * q.z);
    store(entries[TensorBatch::kXY], t.x * p.y + b.x * q.y);
}

}  // namespace

LAPLACIAN_LINES_CLONES
void fit_tensors(const TriangleBatch& triangles, TensorBatch& result) {
    Vector p[3], n[3];
    for (int k = 0; k < 3; ++k)
        p[k] = load(triangles.positions[k]), n[k] = load(triangles.normals[k]);
    const Vector edges[3] = {p[2] - p[1], p[0] - p[2], p[1] - p[0]};
    const Vector changes[3] = {n[2] - n[1], n[0] - n[2], n[1] - n[0]};
    const Vector area = cross(edges[2], p[2] - p[0]);
    const Lanes twice_area = length(area);
    const PlaneTensor tensor = fit((1 / twice_area) * area, twice_area, edges, changes);
    store(result.weights, twice_area);
    store(result.sums, tensor.tt + tensor.tb + tensor.bb);
    for (int k = 0; k < 3; ++k)
        turn(tensor, n[k], twice_area, result.cosines[k], result.tensors[k]);
}

}  // namespace laplacian_lines
