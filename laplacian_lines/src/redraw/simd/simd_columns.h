// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices as columns, for functions of the vertices that are no linear forms.
// Included once by each of the files simd_*.cpp.
#pragma once

#include "redraw/simd/simd_memory.h"
#include "redraw/simd/simd_vectors.h"

namespace laplacian_lines {
namespace SIMD_NAMESPACE {

/// A vector of space in each lane.
struct Vectors {
    Floats x, y, z;

    Vectors operator+(const Vectors& b) const { return {x + b.x, y + b.y, z + b.z}; }
    Vectors operator-(const Vectors& b) const { return {x - b.x, y - b.y, z - b.z}; }
    Vectors operator*(Floats s) const { return {x * s, y * s, z * s}; }
};
static inline Floats dot(const Vectors& a, const Vectors& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Rows of four numbers, one for each lane, as four columns. `row(lane)`: where it is.
template <class Row>
static inline void load_columns(const Row& row, Floats columns[4]) {
    for (unsigned k = 0; k < 4; ++k) {
        Float4 parts[kParts];
        for (unsigned i = 0; i < kParts; ++i)
            parts[i] = load4(row(4 * i + k));
        columns[k] = join(parts);
    }
    transpose_parts(columns);
}
/// The other way round.
template <class Row>
static inline void store_as_rows(Floats columns[4], const Row& row) {
    transpose_parts(columns);
    for (unsigned k = 0; k < 4; ++k) {
        Float4 parts[kParts];
        split(columns[k], parts);
        for (unsigned i = 0; i < kParts; ++i)
            store4(row(4 * i + k), parts[i]);
    }
}

/// kLanes vertices: position, normal, S·D.
class VertexColumns {
public:
    /// Vertices i to i + kLanes − 1 of a cluster; those beyond the last one repeat it.
    VertexColumns(const VertexRecord* records, unsigned i, unsigned count)
        : records_(records), first_(i), last_(count - 1) {
        Floats p[4], a[4], b[4], c[4];
        load_columns([&](unsigned k) { return record(k).position; }, p);
        load_columns([&](unsigned k) { return record(k).shape_operator[0]; }, a);
        load_columns([&](unsigned k) { return record(k).shape_operator[1]; }, b);
        load_columns([&](unsigned k) { return record(k).shape_operator[2]; }, c);
        position = {p[0], p[1], p[2]};
        normal = {a[3], b[3], c[3]};
        rows_[0] = {a[0], b[0], c[0]};
        rows_[1] = {a[1], b[1], c[1]};
        rows_[2] = {a[2], b[2], c[2]};
    }

    Vectors S(const Vectors& x) const {
        return {dot(rows_[0], x), dot(rows_[1], x), dot(rows_[2], x)};
    }

    Vectors position, normal;

protected:
    unsigned number(unsigned lane) const { return first_ + lane < last_ ? first_ + lane : last_; }

private:
    const VertexRecord& record(unsigned lane) const { return records_[number(lane)]; }

    const VertexRecord* const records_;
    const unsigned first_, last_;
    Vectors rows_[3];
};

/// The same with C·D² and the frame that it is given in.
class DerivativeColumns : public VertexColumns {
public:
    /// `derivatives` are the cluster's.
    DerivativeColumns(const VertexRecord* records, const float* derivatives, unsigned i,
                      unsigned count)
        : VertexColumns(records, i, count) {
        load_columns([&](unsigned k) { return derivatives + 4 * number(k); }, c_);
        make_frame();
    }

    /// C(x, y, z) of tangents.
    Floats C(const Vectors& x, const Vectors& y, const Vectors& z) const {
        const Floats xu = dot(u, x), xv = dot(v, x), yu = dot(u, y), yv = dot(v, y);
        const Floats uu = xu * yu, uv = xu * yv + xv * yu, vv = xv * yv;
        return dot(u, z) * (c_[0] * uu + c_[1] * uv + c_[2] * vv) +
               dot(v, z) * (c_[1] * uu + c_[2] * uv + c_[3] * vv);
    }

    Vectors u, v;

private:
    /// tangent_frame().
    void make_frame() {
        const Floats one = Floats{} + 1;
        const Floats sign = (Floats)(((Ints)normal.z & std::int32_t(0x80000000)) | (Ints)one);
        const Floats a = -1 / (sign + normal.z), b = normal.x * normal.y * a;
        u = {1 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x};
        v = {b, sign + normal.y * normal.y * a, -normal.y};
    }

    Floats c_[4];
};

}  // namespace SIMD_NAMESPACE
}  // namespace laplacian_lines
