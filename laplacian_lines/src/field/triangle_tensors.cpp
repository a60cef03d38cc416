// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/triangle_tensors.h"

#include "system/simd_versions.h"

namespace laplacian_lines {
namespace {

template <std::size_t Bytes>
struct Loops {
    static constexpr std::size_t kWidth = Bytes / sizeof(double);
    using Lanes = typename SimdVector<double, Bytes>::Type;

    struct Vector {
        Lanes x, y, z;
        LAPLACIAN_LINES_INLINE Vector operator+(const Vector& b) const {
            return {x + b.x, y + b.y, z + b.z};
        }
        LAPLACIAN_LINES_INLINE Vector operator-(const Vector& b) const {
            return {x - b.x, y - b.y, z - b.z};
        }
        LAPLACIAN_LINES_INLINE Vector operator*(const Lanes& s) const {
            return {s * x, s * y, s * z};
        }
    };

    static LAPLACIAN_LINES_INLINE Lanes dot(const Vector& a, const Vector& b) {
        return a.x * b.x + a.y * b.y + a.z * b.z;
    }
    static LAPLACIAN_LINES_INLINE Vector cross(const Vector& a, const Vector& b) {
        return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    }
    static LAPLACIAN_LINES_INLINE Lanes length(const Vector& a) {
        alignas(Bytes) double lanes[kWidth];
        *reinterpret_cast<Lanes*>(lanes) = dot(a, a);
        for (double& lane : lanes)
            lane = std::sqrt(lane);
        return *reinterpret_cast<const Lanes*>(lanes);
    }

    static LAPLACIAN_LINES_INLINE const Lanes& load(const double* values) {
        return *reinterpret_cast<const Lanes*>(values);
    }
    static LAPLACIAN_LINES_INLINE Vector load(const double values[3][TriangleBatch::kSize],
                                              int lane) {
        return {load(values[0] + lane), load(values[1] + lane), load(values[2] + lane)};
    }
    static LAPLACIAN_LINES_INLINE void store(double* values, const Lanes& v) {
        *reinterpret_cast<Lanes*>(values) = v;
    }

    /// In the plane of a triangle with unit normal n: tt t tᵀ + tb (t bᵀ + b tᵀ) + bb b bᵀ.
    struct PlaneTensor {
        Vector n, t, b;  // orthonormal
        Lanes tt, tb, bb;
    };

    static LAPLACIAN_LINES_INLINE PlaneTensor fit(const Vector& n, const Lanes& twice_area,
                                                  const Vector edges[3], const Vector changes[3]) {
        PlaneTensor tensor;
        tensor.n = n;
        tensor.t = edges[0] * (1 / length(edges[0]));
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
    static LAPLACIAN_LINES_INLINE void turn(const PlaneTensor& tensor, const Vector& m,
                                            const Lanes& weight, int lane, double cosines[],
                                            double entries[][TriangleBatch::kSize]) {
        const Lanes cosine = dot(tensor.n, m);
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

    static LAPLACIAN_LINES_INLINE void fit_some(const TriangleBatch& triangles, int lane,
                                                TensorBatch& result) {
        Vector p[3], n[3];
        for (int k = 0; k < 3; ++k)
            p[k] = load(triangles.positions[k], lane), n[k] = load(triangles.normals[k], lane);
        const Vector edges[3] = {p[2] - p[1], p[0] - p[2], p[1] - p[0]};
        const Vector changes[3] = {n[2] - n[1], n[0] - n[2], n[1] - n[0]};
        const Vector area = cross(edges[2], p[2] - p[0]);
        const Lanes twice_area = length(area);
        const PlaneTensor tensor = fit(area * (1 / twice_area), twice_area, edges, changes);
        store(result.weights + lane, twice_area);
        store(result.sums + lane, tensor.tt + tensor.tb + tensor.bb);
        for (int k = 0; k < 3; ++k)
            turn(tensor, n[k], twice_area, lane, result.cosines[k], result.tensors[k]);
    }

    static LAPLACIAN_LINES_INLINE void fit_all(const TriangleBatch& triangles,
                                               TensorBatch& result) {
        for (int lane = 0; lane < TriangleBatch::kSize; lane += int(kWidth))
            fit_some(triangles, lane, result);
    }
};

LAPLACIAN_LINES_VERSIONS(fit, (const TriangleBatch& triangles, TensorBatch& result),
                         Loops<kBytes>::fit_all(triangles, result))

}  // namespace

void fit_tensors(const TriangleBatch& triangles, TensorBatch& result) {
    fastest_fit(triangles, result);
}

}  // namespace laplacian_lines
