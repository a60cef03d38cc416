// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "sums/simd_grid.h"

namespace laplacian_lines {

/// A regular grid in blocks of 4 x 4 x 4 nodes around points, with room for what they reach. Blocks
/// are numbered along x, y, z; a slab is the blocks of one z, a site a block's number in its slab.
struct GridGeometry {
    GridGeometry(const std::vector<Eigen::Vector3d>& points, double cell);

    /// A point's mass goes to the nodes from floor − 1 to floor + 2 along each axis; its value
    /// comes from floor − 2 to floor + 2 of a second grid, half a cell further on.
    Eigen::Vector3d in_cells(const Eigen::Vector3d& p) const {
        const Eigen::Vector3d cells = (p - origin) * per_cell;
        return {cells[axes[0]], cells[axes[1]], cells[axes[2]]};
    }
    /// The first of these nodes.
    Eigen::Array3i first_node(const Eigen::Vector3d& p) const {
        return in_cells(p).array().cast<int>() - 2;  // none is negative
    }
    std::size_t sites() const { return std::size_t(blocks[0]) * std::size_t(blocks[1]); }
    double block_count() const { return double(blocks[0]) * blocks[1] * blocks[2]; }

    Eigen::Vector3d origin;
    double cell, per_cell;
    int axes[3];  ///< the space's axes along x, y and z of the grid: z is the longest
    int blocks[3];
};

/// Nodes that a point reaches in the box of its block: `offset`..`offset + count − 1` from its
/// first one along each axis.
class ReachedNodes {
public:
    ReachedNodes(int offset, int count);

    /// Calls visit(part, nodes) for each block that the box of the point with this first node
    /// overlaps, see clear_rows().
    template <class Visit>
    void visit_parts(const Eigen::Array3i& first, Visit visit) const {
        const auto& x = masks_[0][first.x() % kBlock];
        const auto& y = masks_[1][first.y() % kBlock];
        const auto& z = masks_[2][first.z() % kBlock];
        for (int part = 0; part < 8; ++part)
            if (const BlockMask mask = x[part & 1] & y[part >> 1 & 1] & z[part >> 2])
                visit(part, mask);
    }

    /// For all points whose first nodes are those of one block.
    template <class Visit>
    void visit_all(BlockMask first_nodes, Visit visit) const {
        for (int bit = 0; first_nodes; first_nodes >>= 1, ++bit)
            if (first_nodes & 1)
                visit_parts({bit % kBlock, bit / kBlock % kBlock, bit / (kBlock * kBlock)}, visit);
    }

private:
    BlockMask masks_[3][kBlock][2] = {};
};

extern const ReachedNodes kSpreadNodes, kInterpolatedNodes;

/// The points of a grid by the block of the first node they reach, in their given order.
class GridPoints {
public:
    GridPoints(const GridGeometry& grid, const std::vector<Eigen::Vector3d>& positions);

    /// Nodes that some point spreads to, or is interpolated from, by block.
    const std::vector<BlockMask>& source_nodes() const { return source_nodes_; }
    const std::vector<BlockMask>& target_nodes() const { return target_nodes_; }
    /// By the points of a block.
    BlockMask first_nodes(std::size_t block) const { return first_nodes_[block]; }
    const std::uint32_t* begin(std::size_t block) const { return order_.data() + starts_[block]; }
    const std::uint32_t* end(std::size_t block) const { return order_.data() + starts_[block + 1]; }

private:
    std::vector<std::uint32_t> starts_, order_;  // starts by block, and an end
    std::vector<BlockMask> first_nodes_;         // of the points of each block
    std::vector<BlockMask> source_nodes_, target_nodes_;
};

}  // namespace laplacian_lines
