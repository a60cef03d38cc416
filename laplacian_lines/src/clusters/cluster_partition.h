// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/prepared_mesh.h"

namespace laplacian_lines {

/// Triangles of a cluster: order[begin..end).
struct ClusterRange {
    std::uint32_t begin, end;
    std::uint32_t vertex_count;
};

/// A mesh cut into clusters. A triangle's place is its number in `order`. Side k of the triangle at
/// place p, from its corner k to the next, has the number 3 p + k.
struct Partition {
    static constexpr std::uint32_t kNobody = 0xffffffffu;
    static constexpr std::uint32_t kMany = 0xfffffffeu;

    std::vector<std::uint32_t> order;  ///< triangles by cluster, ascending within each
    std::vector<ClusterRange> ranges;
    std::vector<std::uint8_t> corners;  ///< [3 p + k]: the corner's number in its cluster
    /// [side]: the other side of its edge within the cluster, kNobody if there is none or one of
    /// the two triangles is coarse and the other is not, kMany if there are several.
    std::vector<std::uint32_t> across;
};

/// Cuts the mesh into pieces that are compact in space and keep within the limits of
/// cluster_data.h, whatever the topology. `coarse`: by triangle, see coarseness.h. The number of
/// threads does not matter.
Partition partition(const PreparedMesh& mesh, const std::vector<std::uint8_t>& coarse);

}  // namespace laplacian_lines
