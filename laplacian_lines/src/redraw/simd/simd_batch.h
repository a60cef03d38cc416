// SPDX-License-Identifier: GPL-3.0-or-later
// Leaves out whole clusters by bounds of n·eye, and begins the work on batches of the others.
#pragma once

#include "redraw/simd/redraw_loops.h"
#include "redraw/simd/simd_signs.h"

namespace laplacian_lines {
namespace SIMD_SET {

/// Of the sum of the terms' sizes: more than rounding makes of n·e − w n·p, which may be far
/// smaller than its terms.
constexpr float kRoundingMargin = 1e-5f;

/// Bounds of n·(e − w p) over the vertices of kFormGroup clusters.
struct FacingRange {
    alignas(kCacheUnit) float low[kFormGroup], high[kFormGroup];
};
static inline FacingRange bound_facing(const FacingBounds& bounds, const float eye[4]) {
    const float w = eye[3], summed = __builtin_fabsf(eye[0]) + __builtin_fabsf(eye[1]) +
                                     __builtin_fabsf(eye[2]) + __builtin_fabsf(w);
    const Vectors e = {Floats{} + eye[0], Floats{} + eye[1], Floats{} + eye[2]};
    FacingRange range;
    for (unsigned i = 0; i < kFormGroup; i += kLanes) {
        const Vectors n = load_vectors(bounds.normal, i),
                      towards = e - load_vectors(bounds.centre, i) * (Floats{} + w);
        Floats reach = w * load(bounds.height_range + i);
        Floats size = absolute(n.x) + absolute(n.y) + absolute(n.z);
        for (const auto& axis : bounds.axes) {
            const Vectors a = load_vectors(axis, i);
            reach += absolute(dot(a, towards));
            size += absolute(a.x) + absolute(a.y) + absolute(a.z);
        }
        reach += kRoundingMargin * size * summed;
        const Floats middle = dot(n, towards) - w * load(bounds.height + i);
        store(range.low + i, middle - reach);
        store(range.high + i, middle + reach);
    }
    return range;
}

/// See StripFunctions. Writes to as many of `kept` as there are clusters, also behind those that it
/// counts.
template <class Kinds>
static std::size_t cull(const ClusterStore& store, const ExtractionTask& task, std::size_t begin,
                        std::size_t end, KeptCluster* kept) {
    std::size_t count = 0;
    for (std::size_t first = begin; first < end; first += kFormGroup) {
        const FacingRange facing = bound_facing(store.facing[first / kFormGroup], task.eye);
        for (unsigned i = 0; i < kFormGroup && first + i < end; ++i) {
            const float low = facing.low[i], high = facing.high[i];
            KeptCluster& cluster = kept[count];
            cluster.number = std::uint32_t(first + i);
            bool any = false, front = low >= 0;
            // Comparisons with NaN are false, so that it excludes nothing.
            Kinds::for_each([&](auto kind, unsigned number) {
                const ExtractionTask::Wanted& wanted = task.kinds[Kinds::kFirst + number];
                const bool excluded =
                    kind.kIsFacing ? (low >= 0) | (high < 0) : high < wanted.least_scaled_facing;
                const bool may_hold = wanted.lines & !excluded;
                cluster.may_hold[number] = may_hold;
                any |= may_hold;
                front &= low >= wanted.least_scaled_facing;
            });
            cluster.test_facing = !front;
            count += any;
        }
    }
    return count;
}

/// Reads memory once. None of these loads waits for another, so that many cache misses are served
/// at a time.
static inline void touch_bytes(const unsigned char* begin, const unsigned char* end) {
    unsigned char sum = 0;
    for (; begin < end; begin += kCacheUnit)
        sum = (unsigned char)(sum ^ *begin);
    asm volatile("" : : "r"(sum));
}

/// Reads what find_active() will go through.
template <class Kinds>
static inline void touch_cluster(const ClusterStore& store, const KeptCluster& kept) {
    const Cluster& cluster = store.clusters[kept.number];
    const unsigned char* memory = memory_of(store, cluster);
    const ClusterLayout layout = cluster_layout(cluster);
    unsigned forms = kept.test_facing ? 1u << kFacingForm : 0;
    Kinds::for_each([&](auto kind, unsigned number) {
        if (kept.may_hold[number]) forms |= kind.kForms;
    });
    const std::size_t form_bytes = form_groups(cluster) * sizeof(FormGroup);
    if (forms >> kFacingForm & 1) touch_bytes(memory, memory + form_bytes);
    if (forms >> kLaplacianForm & 1) {
        const auto* laplacians =
            reinterpret_cast<const unsigned char*>(store.laplacians + cluster.first_form_group);
        touch_bytes(laplacians, laplacians + form_bytes);
    }
    if (Kinds::kReadsCurvatures) {
        const CurvatureRecord* curvatures = store.curvatures + cluster.first_vertex;
        touch_bytes(reinterpret_cast<const unsigned char*>(curvatures),
                    reinterpret_cast<const unsigned char*>(curvatures + cluster.vertex_count));
    }
    touch_bytes(memory + layout.corners, memory + layout.records);
}

/// Fills in what a batch knows of its clusters, and reads what their signs are found from.
template <class Kinds>
static inline void begin_batch(const ClusterStore& store, const KeptCluster* clusters,
                               std::size_t count, Batch& batch) {
    batch.count = unsigned(count);
    batch.records = records_of(store);
    for (std::size_t i = 0; i < count; ++i) {
        const Cluster& cluster = store.clusters[clusters[i].number];
        const ClusterLayout layout = cluster_layout(cluster);
        batch.clusters[i] = &cluster;
        batch.record_offsets[i] = cluster.first_unit +
                                  std::uint32_t(layout.records / sizeof(VertexRecord)) -
                                  std::uint32_t(i * kClusterVertices);
        touch_cluster<Kinds>(store, clusters[i]);
    }
}

static inline ClusterInSlot place_of(const ClusterStore& store, const Batch& batch, unsigned slot) {
    const Cluster& cluster = *batch.clusters[slot];
    return {cluster,
            cluster_layout(cluster),
            memory_of(store, cluster),
            store.laplacians + cluster.first_form_group,
            store.curvatures,
            slot};
}

}  // namespace SIMD_SET
}  // namespace laplacian_lines
