// SPDX-License-Identifier: GPL-3.0-or-later
// Included once by each of the files simd_*.cpp, which define SIMD_NAMESPACE and
// SIMD_SET. Nothing that is inlined elsewhere may be used here, or the linker could keep the
// copy that was compiled for a processor that is not there.
#include <initializer_list>

#include "redraw/simd/simd_active.h"
#include "redraw/simd/simd_culling.h"
#include "redraw/simd/simd_finishing.h"
#include "redraw/simd/simd_strips.h"

namespace laplacian_lines {
namespace SIMD_NAMESPACE {

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
    for (unsigned form = 0; form < kVertexFormCount; ++form)
        if (forms >> form & 1)
            touch(memory + layout.forms[form],
                  memory + layout.forms[form] + layout.corners / kVertexFormCount);
    if (Kinds::kReadsRecords) touch(memory + layout.records, memory + layout.end);
    touch(memory + layout.corners, memory + layout.triangles);
}

template <class Kinds>
static void extract_strips(const ClusterStore& store, const ExtractionTask& task,
                           const KeptCluster* clusters, std::size_t count, SimdMemory& memory,
                           StripOutput* outputs) {
    Batch& batch = memory.batch;
    batch.count = unsigned(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Cluster& cluster = store.clusters[clusters[i].number];
        const ClusterLayout layout = cluster_layout(cluster);
        batch.clusters[i] = &cluster;
        batch.triangles[i] =
            reinterpret_cast<const ClusterTriangle*>(memory_of(store, cluster) + layout.triangles);
        batch.first_record[i] =
            cluster.first_unit + std::uint32_t(layout.records / sizeof(VertexRecord));
        touch<Kinds>(store, clusters[i]);
    }
    find_active<Kinds>(store, task, clusters, batch);
    std::uint32_t begins[Kinds::kCount];
    Kinds::for_each([&](auto kind, unsigned number) {
        begins[number] = outputs[number].strip_count;
        append_strips<Kinds, decltype(kind)>(store, task, number, memory, outputs[number]);
    });
    for (unsigned number = 0; number < Kinds::kCount; ++number)
        name_edges(store, begins[number], outputs[number]);
}

}  // namespace SIMD_NAMESPACE

extern const SimdFunctions SIMD_TABLE;
const SimdFunctions SIMD_TABLE = {
    SIMD_SET,
    {{SIMD_NAMESPACE::cull<SIMD_NAMESPACE::StandardKinds>,
      SIMD_NAMESPACE::extract_strips<SIMD_NAMESPACE::StandardKinds>},
     {SIMD_NAMESPACE::cull<SIMD_NAMESPACE::SuggestiveKinds>,
      SIMD_NAMESPACE::extract_strips<SIMD_NAMESPACE::SuggestiveKinds>}},
    SIMD_NAMESPACE::append_points,
    SIMD_NAMESPACE::finish_line};

}  // namespace laplacian_lines
