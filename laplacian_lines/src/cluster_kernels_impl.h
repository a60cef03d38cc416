// SPDX-License-Identifier: GPL-3.0-or-later
// Included once by each of the files cluster_kernels_*.cpp, which define KERNEL_NAMESPACE and
// KERNEL_SET. Nothing that is inlined elsewhere may be used here, or the linker could keep the
// copy that was compiled for a processor that is not there.
#include <initializer_list>

#include "kernel_culling.h"
#include "kernel_finishing.h"
#include "kernel_signs.h"
#include "kernel_strips.h"

namespace laplacian_lines {
namespace KERNEL_NAMESPACE {

/// Reads the first part of a cluster, which find_active() goes through, once. Caches fetch many
/// lines at a time only if nothing waits for the first of them.
static inline void touch(const ClusterStore& store, const Cluster& cluster) {
    const unsigned char* memory = memory_of(store, cluster);
    const std::size_t bytes = cluster_layout(cluster).triangles;
    unsigned char sum = 0;
    for (std::size_t i = 0; i < bytes; i += kCacheLine)
        sum = (unsigned char)(sum ^ memory[i]);
    asm volatile("" : : "r"(sum));
}

static void extract_strips(const ClusterStore& store, const ExtractionTask& task,
                           const std::uint32_t* clusters, std::size_t count, KernelMemory& memory,
                           StripOutput outputs[2]) {
    for (std::size_t i = 0; i < count; ++i)
        touch(store, store.clusters[clusters[i]]);
    unsigned used = 0;
    for (std::size_t i = 0; i < count; ++i) {
        SignedCluster& signs = memory.clusters[used];
        signs.cluster = &store.clusters[clusters[i]];
        used += find_active(memory_of(store, *signs.cluster), task, signs);
    }
    for (unsigned i = 0; i < used; ++i)
        for (StripKind kind : {kLaplacianStrips, kContourStrips})
            find_strips(store, task, memory.clusters[i], kind, memory, outputs[kind]);
}

}  // namespace KERNEL_NAMESPACE

extern const ClusterKernels KERNEL_TABLE;
const ClusterKernels KERNEL_TABLE = {
    KERNEL_SET, KERNEL_NAMESPACE::cull, KERNEL_NAMESPACE::extract_strips,
    KERNEL_NAMESPACE::append_points, KERNEL_NAMESPACE::finish_line};

}  // namespace laplacian_lines
