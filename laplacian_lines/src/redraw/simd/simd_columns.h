// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices as columns, for functions of the vertices that are no linear forms.
#pragma once

#include "redraw/simd/simd_memory.h"
#include "system/simd_vectors.h"

namespace laplacian_lines {
namespace SIMD_SET {

using Vectors = SpaceVectors<Floats>;

/// Rows of four numbers, one for each lane, as four columns. `row(lane)`: where it is.
template <class Row>
static inline void load_columns(const Row& row, Floats columns[4]) {
    for (unsigned k = 0; k < 4; ++k) {
        Float4 parts[kParts];
        for (unsigned i = 0; i < kParts; ++i)
            parts[i] = load4(row(4 * i + k));
        columns[k] = join(parts);
    }
    transpose(columns);
}
/// The other way round.
template <class Row>
static inline void store_as_rows(Floats columns[4], const Row& row) {
    transpose(columns);
    for (unsigned k = 0; k < 4; ++k) {
        Float4 parts[kParts];
        split(columns[k], parts);
        for (unsigned i = 0; i < kParts; ++i)
            store4(row(4 * i + k), parts[i]);
    }
}

/// A tangent in each lane, by its parts along u and v of the frames that S̄ and C are given in.
struct Tangents {
    Floats u, v;

    Tangents operator-(const Tangents& b) const { return {u - b.u, v - b.v}; }
    Tangents operator+(const Tangents& b) const { return {u + b.u, v + b.v}; }
    Tangents operator*(Floats s) const { return {u * s, v * s}; }
};
static inline Floats dot(const Tangents& a, const Tangents& b) {
    return a.u * b.u + a.v * b.v;
}

/// kLanes vertices with S̄·D, C·D² and the frame that these are given in.
class CurvatureColumns {
public:
    /// Vertices i to i + kLanes − 1 of a cluster; those beyond the last one repeat it.
    CurvatureColumns(const CurvatureRecord* records, unsigned i, unsigned count) {
        const auto record = [&](unsigned lane) -> const CurvatureRecord& {
            return records[i + lane < count ? i + lane : count - 1];
        };
        Floats p[4], n[4], s[4];
        load_columns([&](unsigned k) { return record(k).position; }, p);
        load_columns([&](unsigned k) { return record(k).normal; }, n);
        load_columns([&](unsigned k) { return record(k).curvature; }, s);
        load_columns([&](unsigned k) { return record(k).derivative; }, c_);
        position = {p[0], p[1], p[2]};
        normal = {n[0], n[1], n[2]};
        suu_ = s[0], suv_ = s[1], svv_ = s[2];
        make_frame();
    }

    /// The tangential part of a vector.
    Tangents tangent(const Vectors& x) const { return {dot(u_, x), dot(v_, x)}; }
    Vectors in_space(const Tangents& x) const { return u_ * x.u + v_ * x.v; }

    Tangents S(const Tangents& x) const {
        return {suu_ * x.u + suv_ * x.v, suv_ * x.u + svv_ * x.v};
    }
    Floats C(const Tangents& x, const Tangents& y, const Tangents& z) const {
        const Floats uu = x.u * y.u, uv = x.u * y.v + x.v * y.u, vv = x.v * y.v;
        return z.u * (c_[0] * uu + c_[1] * uv + c_[2] * vv) +
               z.v * (c_[1] * uu + c_[2] * uv + c_[3] * vv);
    }

    Vectors position, normal;

private:
    /// tangent_frame().
    void make_frame() {
        const Floats one = Floats{} + 1;
        const Floats sign = (Floats)(((Ints)normal.z & std::int32_t(0x80000000)) | (Ints)one);
        const Floats a = -1 / (sign + normal.z), b = normal.x * normal.y * a;
        u_ = {1 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x};
        v_ = {b, sign + normal.y * normal.y * a, -normal.y};
    }

    Vectors u_, v_;
    Floats suu_, suv_, svv_, c_[4];
};

}  // namespace SIMD_SET
}  // namespace laplacian_lines
