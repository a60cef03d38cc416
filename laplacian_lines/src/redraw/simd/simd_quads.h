// SPDX-License-Identifier: GPL-3.0-or-later
// Four vertices as columns, for functions of the vertices that are no linear forms.
// Included once by each of the files simd_*.cpp.
#pragma once

#include "redraw/simd/simd_memory.h"
#include "redraw/simd/simd_vectors.h"

namespace laplacian_lines {
namespace SIMD_NAMESPACE {

struct Vector4s {
    Float4 x, y, z;

    Vector4s operator+(const Vector4s& b) const { return {x + b.x, y + b.y, z + b.z}; }
    Vector4s operator-(const Vector4s& b) const { return {x - b.x, y - b.y, z - b.z}; }
    Vector4s operator*(Float4 s) const { return {x * s, y * s, z * s}; }
};
static inline Float4 dot(const Vector4s& a, const Vector4s& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Four vertices: position, normal, S·D and C·D² with the frame that C is given in.
class VertexQuad {
public:
    /// Vertices i to i + 3 of a cluster; those beyond the last one repeat it. `derivatives` are the
    /// cluster's.
    VertexQuad(const VertexRecord* records, const float* derivatives, unsigned i, unsigned count) {
        Float4 p[4], a[4], b[4], c[4];
        for (unsigned k = 0; k < 4; ++k) {
            const unsigned v = i + k < count ? i + k : count - 1;
            p[k] = load4(records[v].position);
            a[k] = load4(records[v].shape_operator[0]);
            b[k] = load4(records[v].shape_operator[1]);
            c[k] = load4(records[v].shape_operator[2]);
            c_[k] = load4(derivatives + 4 * v);
        }
        for (Float4* const rows : {p, a, b, c, c_})
            transpose(rows);
        position = {p[0], p[1], p[2]};
        normal = {a[3], b[3], c[3]};
        rows_[0] = {a[0], b[0], c[0]};
        rows_[1] = {a[1], b[1], c[1]};
        rows_[2] = {a[2], b[2], c[2]};
        make_frame();
    }

    Vector4s S(const Vector4s& x) const {
        return {dot(rows_[0], x), dot(rows_[1], x), dot(rows_[2], x)};
    }

    /// C(x, y, z) of tangents.
    Float4 C(const Vector4s& x, const Vector4s& y, const Vector4s& z) const {
        const Float4 xu = dot(u, x), xv = dot(v, x), yu = dot(u, y), yv = dot(v, y);
        const Float4 uu = xu * yu, uv = xu * yv + xv * yu, vv = xv * yv;
        return dot(u, z) * (c_[0] * uu + c_[1] * uv + c_[2] * vv) +
               dot(v, z) * (c_[1] * uu + c_[2] * uv + c_[3] * vv);
    }

    Vector4s position, normal, u, v;

private:
    /// tangent_frame().
    void make_frame() {
        typedef std::int32_t Int4 __attribute__((vector_size(16)));
        const Float4 one = splat(1.f);
        const Float4 sign = (Float4)(((Int4)normal.z & std::int32_t(0x80000000)) | (Int4)one);
        const Float4 a = -1 / (sign + normal.z), b = normal.x * normal.y * a;
        u = {1 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x};
        v = {b, sign + normal.y * normal.y * a, -normal.y};
    }

    Vector4s rows_[3];
    Float4 c_[4];
};

}  // namespace SIMD_NAMESPACE
}  // namespace laplacian_lines
