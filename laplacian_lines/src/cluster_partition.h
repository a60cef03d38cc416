// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "prepared_mesh.h"

namespace laplacian_lines {

/// What is across the sides of a triangle; side k goes from corner k to the next.
struct TriangleSides {
    static constexpr std::uint32_t kNone = 0xffffffffu;
    std::uint32_t edges[3];       ///< numbers of the undirected edges
    std::uint32_t neighbours[3];  ///< triangle, kNone unless exactly two triangles share the edge
    bool reversed[3];             ///< the neighbour has the opposite orientation
};

std::vector<TriangleSides> find_sides(const PreparedMesh& mesh, std::size_t& edge_count);

/// Triangles of a cluster: order[begin..end).
struct ClusterRange {
    std::uint32_t begin, end;
};

/// Cuts the mesh into pieces that are compact in space and keep within the limits of
/// cluster_data.h, whatever the topology. `order` becomes a permutation of the triangles.
std::vector<ClusterRange> partition(const PreparedMesh& mesh,
                                    const std::vector<TriangleSides>& sides,
                                    std::vector<std::uint32_t>& order);

}  // namespace laplacian_lines
