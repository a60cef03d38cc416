// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clusters/cluster_partition.h"

namespace laplacian_lines {

/// What lies across sides of triangles, by 3 place + k.
struct ClusterLinks {
    static constexpr std::uint32_t kNobody = 0xffffffffu;  ///< lines end there
    static constexpr std::uint32_t kNumber = 0x80000000u;  ///< and the number of an edge

    std::vector<std::uint32_t> across;  ///< a place in the cluster, a number or kNobody
    std::uint32_t number_count = 0;     ///< of edges at which lines are joined, over the mesh

    static bool is_number(std::uint32_t across) { return across >= kNumber && across != kNobody; }
};

/// The number of threads does not matter.
ClusterLinks link_clusters(const PreparedMesh& mesh, const CornerTable& sides,
                           const std::vector<std::uint8_t>& coarse, const Partition& partition);

}  // namespace laplacian_lines
