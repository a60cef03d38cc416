// SPDX-License-Identifier: GPL-3.0-or-later
// Which triangles of a cluster a function changes its sign in.
// Included once by each of the files simd_*.cpp.
#pragma once

#include <cstdint>

#include "redraw/simd/simd_functions.h"
#include "redraw/simd/simd_vectors.h"

namespace laplacian_lines {
namespace SIMD_NAMESPACE {

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

/// Appends the triangles of a mask, which is for those from number `first` on, and asks for them.
static inline void list_mixed(std::uint64_t mask, const std::uint64_t negative[3], unsigned slot,
                              unsigned first, const ClusterTriangle* triangles,
                              ActiveTriangles& active) {
    unsigned count = active.count;
    for (; mask; mask &= mask - 1) {
        const auto i = unsigned(__builtin_ctzll(mask));
        __builtin_prefetch(&triangles[first + i]);
        active.slot[count] = std::uint8_t(slot);
        active.number[count] = std::uint8_t(first + i);
        active.negative[count] = std::uint8_t((negative[0] >> i & 1) | (negative[1] >> i & 1) << 1 |
                                              (negative[2] >> i & 1) << 2);
        ++count;
    }
    active.count = count;
}

/// Which signs a cluster has, of those that decide about its triangles.
struct ClusterSigns {
    VertexSigns vertices;
    bool mixed[2];  ///< by StripKind
    bool any_away;
};

/// Fills in the values of the cluster in a slot.
static inline ClusterSigns find_signs(const unsigned char* memory, const ExtractionTask& task,
                                      const KeptCluster& kept, unsigned slot, Batch& batch) {
    const Cluster& cluster = *batch.clusters[slot];
    const ClusterLayout layout = cluster_layout(cluster);
    const unsigned groups = form_groups(cluster);
    BelowBound contour, away, laplacian;
    away.all = contour.all = false;
    if (kept.test_facing) {
        float* facing = batch.values[kContourStrips] + slot * kClusterVertices;
        evaluate(reinterpret_cast<const float*>(memory), groups, task.eye, facing);
        contour = below(facing, groups, 0);
        away = task.least_scaled_facing == 0 ? contour
                                             : below(facing, groups, task.least_scaled_facing);
    }
    if (kept.test_laplacian && !away.all) {
        float* values = batch.values[kLaplacianStrips] + slot * kClusterVertices;
        evaluate(reinterpret_cast<const float*>(memory + layout.laplacians), groups, task.light,
                 values);
        if (task.exact_point_light)
            subtract_traces(reinterpret_cast<const VertexRecord*>(memory + layout.records), cluster,
                            task.light[3], values);
        laplacian = below(values, groups, 0);
    }
    ClusterSigns signs;
    signs.mixed[kContourStrips] = task.wanted[kContourStrips] && contour.any && !contour.all;
    signs.mixed[kLaplacianStrips] = laplacian.any && !laplacian.all;
    signs.any_away = away.any;
    if (signs.mixed[kContourStrips]) signs.vertices.set(kContourStrips, contour.bits);
    if (signs.mixed[kLaplacianStrips]) {
        signs.vertices.set(kLaplacianStrips, laplacian.bits);
        if (away.any) signs.vertices.set(kAwaySet, away.bits);
    }
    return signs;
}

/// Appends the triangles of the cluster in a slot in which a function changes its sign.
static inline void find_mixed(const unsigned char* memory, const ExtractionTask& task,
                              const ClusterSigns& signs, unsigned slot, Batch& batch) {
    const Cluster& cluster = *batch.clusters[slot];
    const unsigned char* corners = memory + cluster_layout(cluster).corners;
    for (unsigned g = 0; g < mask_groups(cluster); ++g, corners += 3 * kMaskGroup) {
        const CornerLookup lookup[3] = {{corners, signs.vertices},
                                        {corners + kMaskGroup, signs.vertices},
                                        {corners + 2 * kMaskGroup, signs.vertices}};
        const auto list = [&](StripKind kind, std::uint64_t unwanted) {
            const std::uint64_t n[3] = {lookup[0](kind), lookup[1](kind), lookup[2](kind)};
            const std::uint64_t mixed = ((n[0] ^ n[1]) | (n[0] ^ n[2])) & ~unwanted;
            list_mixed(mixed, n, slot, g * kMaskGroup, batch.triangles[slot], batch.active[kind]);
        };
        if (signs.mixed[kContourStrips]) list(kContourStrips, 0);
        if (signs.mixed[kLaplacianStrips]) {
            const bool leave_out = task.rules[kLaplacianStrips].leave_out_convex;
            const std::uint64_t convex = leave_out ? cluster.convex[g] : 0;
            const std::uint64_t all_away =
                signs.any_away ? lookup[0](kAwaySet) & lookup[1](kAwaySet) & lookup[2](kAwaySet)
                               : 0;
            list(kLaplacianStrips, convex | all_away);
        }
    }
}

/// Reads the listed triangles and asks for the records of their crossings.
static inline void read_active(const ClusterStore& store, const Batch& batch,
                               ActiveTriangles& active) {
    for (unsigned i = 0; i < active.count; ++i) {
        const unsigned slot = active.slot[i];
        ActiveTriangle& triangle = active.triangles[i];
        write_active(batch.triangles[slot][active.number[i]], active.negative[i], triangle);
        const VertexRecord* records = records_of(store) + batch.first_record[slot];
        __builtin_prefetch(&records[triangle.exit[0]]);
        __builtin_prefetch(&records[triangle.exit[1]]);
        __builtin_prefetch(&records[triangle.third]);
    }
}

/// Fills in values and active triangles of a batch.
static inline void find_active(const ClusterStore& store, const ExtractionTask& task,
                               const KeptCluster* kept, Batch& batch) {
    batch.active[0].count = batch.active[1].count = 0;
    for (unsigned slot = 0; slot < batch.count; ++slot) {
        const unsigned char* memory = memory_of(store, *batch.clusters[slot]);
        const ClusterSigns signs = find_signs(memory, task, kept[slot], slot, batch);
        if (signs.mixed[0] || signs.mixed[1]) find_mixed(memory, task, signs, slot, batch);
    }
    for (ActiveTriangles& active : batch.active)
        read_active(store, batch, active);
}

}  // namespace SIMD_NAMESPACE
}  // namespace laplacian_lines
