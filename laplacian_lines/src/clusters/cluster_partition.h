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
/// cluster_data.h, whatever the topology. `coarse`: by triangle, see coarseness.h. The number of
/// threads does not matter.
Partition partition(const PreparedMesh& mesh, const CornerTable& sides,
                    const std::vector<std::uint8_t>& coarse);

/// Whether a redraw goes on from a triangle to the next without an edge's number: within a cluster,
/// one orientation and coarseness. Else lines are joined at the number.
inline bool goes_on_within(const PreparedMesh& mesh, const std::vector<std::uint8_t>& coarse,
                           std::uint32_t side, std::uint32_t across) {
    return begin_of(mesh.triangles, side) != begin_of(mesh.triangles, across) &&
           coarse[side / 3] == coarse[across / 3];
}

}  // namespace laplacian_lines
