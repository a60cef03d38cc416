// SPDX-License-Identifier: GPL-3.0-or-later
// What begins the work on a batch of clusters.
#pragma once

#include "redraw/simd/simd_kinds.h"

namespace laplacian_lines {
namespace SIMD_SET {

/// Reads memory once. Caches fetch many lines at a time only if nothing waits for the first of
/// them.
static inline void touch(const unsigned char* begin, const unsigned char* end) {
    unsigned char sum = 0;
    for (; begin < end; begin += kCacheUnit)
        sum = (unsigned char)(sum ^ *begin);
    asm volatile("" : : "r"(sum));
}

/// Reads what find_active() will go through.
template <class Kinds>
static inline void touch(const ClusterStore& store, const KeptCluster& kept) {
    const Cluster& cluster = store.clusters[kept.number];
    const unsigned char* memory = memory_of(store, cluster);
    const ClusterLayout layout = cluster_layout(cluster);
    unsigned forms = kept.test_facing ? 1u << kFacingForm : 0;
    Kinds::for_each([&](auto kind, unsigned number) {
        if (kept.may_hold[number]) forms |= kind.kForms;
    });
    if (forms >> kFacingForm & 1) touch(memory, memory + layout.corners);
    if (forms >> kLaplacianForm & 1) {
        const auto* laplacians =
            reinterpret_cast<const unsigned char*>(store.laplacians + cluster.first_form_group);
        touch(laplacians, laplacians + layout.corners);
    }
    if (Kinds::kReadsCurvatures) {
        const CurvatureRecord* curvatures = store.curvatures + cluster.first_vertex;
        touch(reinterpret_cast<const unsigned char*>(curvatures),
              reinterpret_cast<const unsigned char*>(curvatures + cluster.vertex_count));
    }
    touch(memory + layout.corners, memory + layout.records);
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
        touch<Kinds>(store, clusters[i]);
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
