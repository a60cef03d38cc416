// SPDX-License-Identifier: GPL-3.0-or-later
// Zero crossings on edges: L. Zhang, Y. He, X. Xie, W. Chen, "Laplacian Lines for
// Real-Time Shape Illustration", step 2 of the extraction.
#pragma once

#include <cfloat>

#include "redraw/simd/simd_signs.h"

namespace laplacian_lines {
namespace SIMD_SET {

// ---- vertices as columns, for functions of the vertices that are no linear forms ----

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
    /// As tangent_frame().
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

// ---- crossings ----

static inline Vectors cross(const Vectors& a, const Vectors& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Where crossings [0, count) are on their edges, from the values at the ends.
static inline void find_shares(const float* values, CrossingMemory& m, std::size_t count) {
    count = whole_vectors(count);
    for (std::size_t i = 0; i < count; ++i) {
        m.below[i] = values[m.ends[i][0]];
        m.above[i] = values[m.ends[i][1]];
    }
    for (std::size_t i = 0; i < count; i += kLanes) {
        const Floats below = absolute(load(m.below + i));
        const Floats sum = below + absolute(load(m.above + i));
        const Floats share = below / sum;  // sum > 0: one end is negative
        store(m.share + i, sum <= FLT_MAX ? share : Floats{} + 0.5f);
    }
}

/// Positions of crossings, and there S l and n·l in the last place, S and n interpolated, l the
/// vector to `source`, an eye or light.
struct EdgePoints {
    Floats position[4], gradient[4];
};
static inline EdgePoints find_edge_points(const Batch& batch, const float source[4],
                                          const CrossingMemory& m, std::size_t i) {
    const float *below[kLanes], *above[kLanes];  // records, as rows of four
    for (unsigned k = 0; k < kLanes; ++k) {
        const RecordsOfSlot records = records_around(batch, m.ends[i + k][0]);
        below[k] = position_at(records, m.ends[i + k][0]);
        above[k] = position_at(records, m.ends[i + k][1]);
    }
    const Floats t = load(m.share + i), s = 1 - t;
    const auto interpolate = [&](unsigned row, Floats columns[4]) {
        Floats b[4];
        load_columns([&](unsigned lane) { return below[lane] + 4 * row; }, columns);
        load_columns([&](unsigned lane) { return above[lane] + 4 * row; }, b);
        for (unsigned k = 0; k < 4; ++k)
            columns[k] = s * columns[k] + t * b[k];
    };
    EdgePoints points;
    interpolate(0, points.position);
    for (unsigned row = 0; row < 3; ++row) {
        const Floats l = source[row] - source[3] * points.position[row];
        Floats columns[4];
        interpolate(1 + row, columns);
        for (unsigned k = 0; k < 4; ++k)
            points.gradient[k] = row == 0 ? columns[k] * l : points.gradient[k] + columns[k] * l;
    }
    return points;
}

/// Positions, gradients S l and n·l of crossings [0, count).
static inline void find_points(const Batch& batch, const float source[4], CrossingMemory& m,
                               std::size_t count) {
    for (std::size_t i = 0; i < count; i += kLanes) {
        EdgePoints points = find_edge_points(batch, source, m, i);
        auto& [p, g] = points;
        p[3] = square_root(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
        store_vectors({p[0], p[1], p[2]}, m.position, i);
        store_vectors({g[0], g[1], g[2]}, m.g, i);
        store(m.lit + i, g[3]);
        store(m.gradient + i, p[3]);
        store_as_rows(p, [&](unsigned lane) { return m.points[i + lane]; });
    }
}

/// n·eye of crossings [0, count), where the light is elsewhere.
static inline void find_facing(const Batch& batch, const float eye[4], CrossingMemory& m,
                               std::size_t count) {
    for (std::size_t i = 0; i < count; i += kLanes)
        store(m.facing + i, find_edge_points(batch, eye, m, i).gradient[3]);
}

/// Notes which of crossings [i, i + kLanes) are accepted.
static inline void accept(Ints accepted, CrossingMemory& m, std::size_t i) {
    const std::uint64_t bits = bits_of(accepted);
    if (i % 64 == 0)
        m.accepted[i / 64] = bits;
    else
        m.accepted[i / 64] |= bits << i % 64;
}

/// From crossings [i, i + kLanes) to an eye or light.
static inline Vectors towards(const float eye[4], const CrossingMemory& m, std::size_t i) {
    const Vectors e = {Floats{} + eye[0], Floats{} + eye[1], Floats{} + eye[2]};
    return e - load_vectors(m.position, i) * (Floats{} + eye[3]);
}

/// What the slope of a segment is, with ∇f of the linear interpolant and the vectors d that a
/// kind's test() leaves in CrossingMemory::g. Of whole lines it is less than 0 where ∇f·d > 0.
enum class SegmentSlope {
    Scaled,     ///< ‖∇f‖ times LineRules::slope_scale
    Along,      ///< −∇f·d, a change in a squared length, times h_e, to the power 1.5
    AlongOnce,  ///< −∇f·d, a change in a length to the power 3, times h_e^1.5
};

}  // namespace SIMD_SET
}  // namespace laplacian_lines
