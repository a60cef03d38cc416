// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/corner_table.h"
#include "mesh/prepared_mesh.h"

namespace laplacian_lines {

/// Triangles of a cluster: order[begin..end).
struct ClusterRange {
    std::uint32_t begin, end;
    std::uint32_t vertex_count;
};

/// A mesh cut into clusters. A triangle's place is its number in `order`.
struct Partition {
    std::vector<std::uint32_t> order;  ///< triangles by cluster, ascending within each
    std::vector<ClusterRange> ranges;
    std::vector<std::uint8_t> corners;  ///< [3 place + k]: the corner's number in its cluster
    std::vector<std::uint32_t> places;  ///< by triangle
};

/// Cuts the mesh into pieces that are compact in space and keep within the limits of
/// cluster_data.h, whatever the topology. The number of threads does not matter.
Partition partition(const PreparedMesh& mesh, const CornerTable& sides);

/// What lies across sides of triangles, by 3 place + k.
struct ClusterLinks {
    static constexpr std::uint32_t kNobody = 0xffffffffu;  ///< lines end there
    static constexpr std::uint32_t kNumber = 0x80000000u;  ///< plus the number of an edge

    std::vector<std::uint32_t> across;  ///< a place in the cluster, a number or kNobody
    std::uint32_t number_count = 0;     ///< of edges at which lines are joined, over the mesh

    static bool is_number(std::uint32_t across) { return across >= kNumber && across != kNobody; }
};

ClusterLinks link_clusters(const PreparedMesh& mesh, const CornerTable& sides,
                           const Partition& partition);

}  // namespace laplacian_lines
