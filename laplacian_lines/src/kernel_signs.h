// SPDX-License-Identifier: GPL-3.0-or-later
// Which triangles of a cluster a function changes its sign in.
// Included once by each of the files cluster_kernels_*.cpp.
#pragma once

#include <cstdint>

#include "cluster_kernels.h"
#include "kernel_vectors.h"

namespace laplacian_lines {
namespace KERNEL_NAMESPACE {

/// Linear forms v·(e − w p) of all vertices.
static inline void evaluate(const float* forms, unsigned groups, const float eye[4],
                            float* values) {
    const float ex = eye[0], ey = eye[1], ez = eye[2], w = eye[3];
    for (unsigned g = 0; g < groups; ++g, forms += 4 * kFormGroup, values += kFormGroup)
        for (unsigned i = 0; i < kFormGroup; i += kLanes)
            store(values + i, load(forms + i) * ex + load(forms + kFormGroup + i) * ey +
                                  load(forms + 2 * kFormGroup + i) * ez -
                                  w * load(forms + 3 * kFormGroup + i));
}

/// The cross term that the paper's derivation loses. Places that are left over repeat the last
/// vertex, as in the forms.
static inline void subtract_traces(const VertexRecord* records, const Cluster& cluster, float w,
                                   float* values) {
    for (unsigned i = 0; i < form_groups(cluster) * kFormGroup; ++i) {
        const unsigned v = i < cluster.vertex_count ? i : cluster.vertex_count - 1u;
        const auto& s = records[v].shape_operator;
        values[i] -= w * (s[0][0] + s[1][1] + s[2][2]);
    }
}

/// Beside those of StripKind, the bits of vertices that surely face away.
constexpr unsigned kAwaySet = 2;

/// How many of a cluster's values are below a bound, and which.
struct BelowBound {
    VertexBits bits{{0, 0}};
    bool any = false, all = true;
};

static inline BelowBound below(const float* values, unsigned groups, float bound) {
    BelowBound result;
    unsigned any = 0, all = 0xffff;
    for (unsigned g = 0; g < groups; ++g) {
        const unsigned mask = mask_below(values + g * kFormGroup, bound);
        result.bits.words[g / 4] |= std::uint64_t(mask) << g % 4 * kFormGroup;
        any |= mask;
        all &= mask;
    }
    result.any = any != 0;
    result.all = all == 0xffff;
    return result;
}

/// Places in ClusterTriangle's bytes that make an ActiveTriangle, by which corners are negative.
/// A line leaves through the edge that goes from a negative to a positive corner.
struct alignas(16) ActivePattern {
    std::uint8_t places[16];
};
constexpr ActivePattern active_pattern(unsigned exit, bool third_is_negative) {
    const auto a = std::uint8_t(exit), b = std::uint8_t((exit + 1) % 3),
               c = std::uint8_t((exit + 2) % 3);
    const std::uint8_t entry = third_is_negative ? b : c;
    return {{a, b, third_is_negative ? c : a, third_is_negative ? b : c, c, std::uint8_t(3 + a),
             std::uint8_t(3 + entry), 7}};
}
constexpr ActivePattern kActivePatterns[8] = {
    {},                        // none: no crossing
    active_pattern(0, false),  // the first corner alone
    active_pattern(1, false),  // the second
    active_pattern(1, true),   // the first and the second
    active_pattern(2, false),  // the third
    active_pattern(0, true),   // the third and the first
    active_pattern(2, true),   // the second and the third
    {},
};

static inline void write_active(const ClusterTriangle& triangle, unsigned negative_corners,
                                ActiveTriangle& active) {
    const ActivePattern& pattern = kActivePatterns[negative_corners];
#if defined(__SSSE3__)
    const __m128i bytes = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(&triangle));
    const __m128i places = _mm_load_si128(reinterpret_cast<const __m128i*>(pattern.places));
    _mm_storel_epi64(reinterpret_cast<__m128i*>(&active), _mm_shuffle_epi8(bytes, places));
#else
    unsigned char from[8], to[8];
    __builtin_memcpy(from, &triangle, 8);
    for (int i = 0; i < 8; ++i)
        to[i] = from[pattern.places[i]];
    __builtin_memcpy(&active, to, 8);
#endif
}

/// Appends the triangles of a mask to a list.
static inline unsigned list_active(std::uint64_t mask, const std::uint64_t negative[3],
                                   const ClusterTriangle* triangles, const VertexRecord* records,
                                   ActiveTriangle* active, unsigned count) {
    for (; mask; mask &= mask - 1) {
        const int i = __builtin_ctzll(mask);
        const auto corners = unsigned((negative[0] >> i & 1) | (negative[1] >> i & 1) << 1 |
                                      (negative[2] >> i & 1) << 2);
        ActiveTriangle& a = active[count++];
        write_active(triangles[i], corners, a);
        __builtin_prefetch(&records[a.exit[0]]);
        __builtin_prefetch(&records[a.exit[1]]);
    }
    return count;
}

/// Fills in values and active triangles of a cluster. Returns whether there are any of these.
static inline bool find_active(const unsigned char* memory, const ExtractionTask& task,
                               SignedCluster& signs) {
    const Cluster& cluster = *signs.cluster;
    const ClusterLayout layout = cluster_layout(cluster);
    const auto* records = reinterpret_cast<const VertexRecord*>(memory + layout.records);
    const unsigned groups = form_groups(cluster);
    signs.count[0] = signs.count[1] = 0;

    float* facing = signs.values[kContourStrips];
    evaluate(reinterpret_cast<const float*>(memory), groups, task.eye, facing);
    const BelowBound contour = below(facing, groups, 0);
    const BelowBound away = below(facing, groups, task.least_scaled_facing);
    const bool mixed_contour = task.wanted[kContourStrips] && contour.any && !contour.all;

    float* values = signs.values[kLaplacianStrips];
    BelowBound laplacian;
    if (task.wanted[kLaplacianStrips] && !away.all) {
        evaluate(reinterpret_cast<const float*>(memory + layout.laplacians), groups, task.light,
                 values);
        if (task.exact_point_light) subtract_traces(records, cluster, task.light[3], values);
        laplacian = below(values, groups, 0);
    }
    const bool mixed_laplacian = laplacian.any && !laplacian.all;
    if (!mixed_contour && !mixed_laplacian) return false;

    VertexSigns vertices;
    if (mixed_contour) vertices.set(kContourStrips, contour.bits);
    if (mixed_laplacian) vertices.set(kLaplacianStrips, laplacian.bits);
    if (mixed_laplacian && away.any) vertices.set(kAwaySet, away.bits);
    const unsigned char* corners = memory + layout.corners;
    const auto* triangles = reinterpret_cast<const ClusterTriangle*>(memory + layout.triangles);
    for (unsigned g = 0; g < mask_groups(cluster); ++g) {
        const CornerLookup lookup[3] = {{corners, vertices},
                                        {corners + kMaskGroup, vertices},
                                        {corners + 2 * kMaskGroup, vertices}};
        const auto list = [&](StripKind kind, std::uint64_t unwanted) {
            const std::uint64_t n[3] = {lookup[0](kind), lookup[1](kind), lookup[2](kind)};
            const std::uint64_t mixed = ((n[0] ^ n[1]) | (n[0] ^ n[2])) & ~unwanted;
            signs.count[kind] =
                list_active(mixed, n, triangles, records, signs.active[kind], signs.count[kind]);
        };
        if (mixed_contour) list(kContourStrips, 0);
        if (mixed_laplacian) {
            const bool leave_out = task.rules[kLaplacianStrips].leave_out_convex;
            const std::uint64_t convex = leave_out ? cluster.convex[g] : 0;
            const std::uint64_t all_away =
                away.any ? lookup[0](kAwaySet) & lookup[1](kAwaySet) & lookup[2](kAwaySet) : 0;
            list(kLaplacianStrips, convex | all_away);
        }
        corners += 3 * kMaskGroup;
        triangles += kMaskGroup;
    }
    return signs.count[0] + signs.count[1] > 0;
}

}  // namespace KERNEL_NAMESPACE
}  // namespace laplacian_lines
