// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clusters/cluster_partition.h"

namespace laplacian_lines {

/// Marks the number of an edge that two clusters share, or two triangles of opposite orientation,
/// or a coarse triangle and one that is not.
constexpr std::uint32_t kSharedEdge = 0x80000000u;

inline bool is_shared_edge(std::uint32_t across) {
    return across >= kSharedEdge && across < Partition::kMany;
}

/// Completes Partition::across by what is in other clusters: a side of the same cluster and the
/// same orientation, or kSharedEdge plus the number of an edge, or kNobody or kMany where the
/// surface ends. Returns the number of such edges. The number of threads does not matter.
std::uint32_t link_clusters(const PreparedMesh& mesh, Partition& partition);

}  // namespace laplacian_lines
