// SPDX-License-Identifier: GPL-3.0-or-later
// Zero crossings on edges: L. Zhang, Y. He, H. S. Seah, "Laplacian Lines for
// Real-Time Shape Illustration", step 2 of the extraction.
// Included once by each of the files simd_*.cpp.
#pragma once

#include <cfloat>

#include "redraw/simd/simd_memory.h"
#include "redraw/simd/simd_vectors.h"

namespace laplacian_lines {
namespace SIMD_NAMESPACE {

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
        const Floats share = below / sum;  // sum > 0: one side is negative
        store(m.share + i, sum <= FLT_MAX ? share : Floats{} + 0.5f);
    }
}

/// A point on an edge, and there S l and n·l in the last place, S and n interpolated.
struct EdgePoint {
    Float4 position, gradient;
};
static inline EdgePoint find_point(const VertexRecord& a, const VertexRecord& b, float share,
                                   Float4 light, Float4 w) {
#if defined(__AVX512F__)
    const __m512 t = _mm512_set1_ps(share), s = _mm512_set1_ps(1 - share);
    const __m512 rows = s * _mm512_load_ps(a.position) + t * _mm512_load_ps(b.position);
    const Float4 position = _mm512_castps512_ps128(rows), l = light - w * position;
    const __m512i places = _mm512_set_epi32(2, 2, 2, 2, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0);
    const __m512 products = rows * _mm512_permutexvar_ps(places, _mm512_castps128_ps512(l));
    return {position, _mm512_extractf32x4_ps(products, 1) + _mm512_extractf32x4_ps(products, 2) +
                          _mm512_extractf32x4_ps(products, 3)};
#else
    const Float4 t = splat(share), s = splat(1 - share);
    const auto row = [&](const float* of_a, const float* of_b) {
        return s * load4(of_a) + t * load4(of_b);
    };
    const Float4 position = row(a.position, b.position), l = light - w * position;
    return {position, row(a.shape_operator[0], b.shape_operator[0]) * splat<0>(l) +
                          row(a.shape_operator[1], b.shape_operator[1]) * splat<1>(l) +
                          row(a.shape_operator[2], b.shape_operator[2]) * splat<2>(l)};
#endif
}

/// Positions, gradients and n·light of crossings [0, count), as rows and as columns.
static inline void find_points(const VertexRecord* records, const float eye_of_light[4],
                               CrossingMemory& m, std::size_t count) {
    const Float4 light = {eye_of_light[0], eye_of_light[1], eye_of_light[2], 0};
    const Float4 w = splat(eye_of_light[3]);
    for (std::size_t i = 0; i < count; i += 4) {
        Float4 points[4], gradients[4];
        for (unsigned k = 0; k < 4; ++k) {
            const EdgePoint found =
                find_point(records[m.records[i + k][0]], records[m.records[i + k][1]],
                           m.share[i + k], light, w);
            points[k] = found.position;
            store4(m.gradients[i + k], gradients[k] = found.gradient);
        }
        transpose(gradients);
        const Float4 x = gradients[0], y = gradients[1], z = gradients[2];
        const Float4 norms = square_root4(x * x + y * y + z * z);
        store_row(norms, m.gradient + i);
        store4(m.points[i], shuffle<0, 1, 2, 4>(points[0], norms));
        store4(m.points[i + 1], shuffle<0, 1, 2, 5>(points[1], norms));
        store4(m.points[i + 2], shuffle<0, 1, 2, 6>(points[2], norms));
        store4(m.points[i + 3], shuffle<0, 1, 2, 7>(points[3], norms));
        transpose(points);
        store_columns(points, m.x + i, m.y + i, m.z + i);
        store_columns(gradients, m.gx + i, m.gy + i, m.gz + i);
        store_row(gradients[3], m.lit + i);
    }
}

/// n·eye of crossings [0, count), where the light is elsewhere.
static inline void find_facing(const VertexRecord* records, const float eye[4], CrossingMemory& m,
                               std::size_t count) {
    const Float4 e = {eye[0], eye[1], eye[2], 0}, w = splat(eye[3]);
    for (std::size_t i = 0; i < count; ++i)
        m.facing[i] =
            find_point(records[m.records[i][0]], records[m.records[i][1]], m.share[i], e, w)
                .gradient[3];
}

/// Notes which of crossings [i, i + kLanes) are accepted.
static inline void accept(Ints accepted, CrossingMemory& m, std::size_t i) {
    const std::uint64_t bits = bits_of(accepted);
    if (i % 64 == 0)
        m.accepted[i / 64] = bits;
    else
        m.accepted[i / 64] |= bits << i % 64;
}

/// Columns of gradients that a kind has changed, as rows.
static inline void store_gradients(CrossingMemory& m, std::size_t count) {
    for (std::size_t i = 0; i < count; i += 4) {
        Float4 rows[4] = {load4(m.gx + i), load4(m.gy + i), load4(m.gz + i), load4(m.lit + i)};
        transpose(rows);
        for (unsigned k = 0; k < 4; ++k)
            store4(m.gradients[i + k], rows[k]);
    }
}

/// From crossings [i, i + kLanes) to an eye or light, and the square of the distance.
struct Towards {
    Floats x, y, z, squared;
};
static inline Towards towards(const float eye[4], const CrossingMemory& m, std::size_t i) {
    const Floats x = eye[0] - eye[3] * load(m.x + i), y = eye[1] - eye[3] * load(m.y + i),
                 z = eye[2] - eye[3] * load(m.z + i);
    return {x, y, z, x * x + y * y + z * z};
}

}  // namespace SIMD_NAMESPACE
}  // namespace laplacian_lines
