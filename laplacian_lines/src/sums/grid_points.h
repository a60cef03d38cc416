// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sums/simd_grid.h"

namespace laplacian_lines {

/// A regular grid around points and the support of their splines, in blocks of 4 x 4 x 4 nodes.
/// Blocks are numbered along x, y, z; a slab is the blocks of one z, a site a block's number in its
/// slab. No point's first node is in the last block along an axis.
struct GridGeometry {
    GridGeometry(const std::vector<Eigen::Vector3d>& points, double cell);

    /// A point's place along the grid's axes. Its mass goes to the nodes from floor − 1 to floor +
    /// 2 along each; its value comes from floor − 2 to floor + 2 of a second grid, half a cell
    /// further on.
    Eigen::Vector3d in_cells(const Eigen::Vector3d& p) const {
        const Eigen::Vector3d cells = (p - origin) * per_cell;
        return {cells[axes[0]], cells[axes[1]], cells[axes[2]]};
    }
    /// The first of these nodes.
    Eigen::Array3i first_node(const Eigen::Vector3d& p) const {
        return in_cells(p).array().cast<int>() - 2;  // none is negative
    }
    std::size_t sites() const { return std::size_t(blocks[0]) * std::size_t(blocks[1]); }
    /// A double, since tiny cells may make more than integers hold.
    double block_count() const { return double(blocks[0]) * blocks[1] * blocks[2]; }
    /// From a block's number to that of the block that a part of its points' box lies in: bits 0, 1
    /// and 2 of `part` are for the next one along x, y and z.
    std::size_t step_to(int part) const {
        return std::size_t(part & 1) + std::size_t(part >> 1 & 1) * std::size_t(blocks[0]) +
               std::size_t(part >> 2) * sites();
    }

    Eigen::Vector3d origin;
    double cell, per_cell;  ///< a cell's side, local units, and its inverse
    int axes[3];            ///< the space's axes along x, y and z of the grid: z is the longest
    int blocks[3];
};

/// The points of a grid, sorted by the block of first_node(); in a block they keep their order.
class GridPoints {
public:
    GridPoints(const GridGeometry& grid, const std::vector<Eigen::Vector3d>& positions);

    /// By block, whether any point's splines reach it.
    const std::vector<std::uint8_t>& reached() const { return reached_; }
    const std::uint32_t* begin(std::size_t block) const { return order_.data() + starts_[block]; }
    const std::uint32_t* end(std::size_t block) const { return order_.data() + starts_[block + 1]; }

private:
    std::vector<std::uint32_t> starts_, order_;  // starts by block, and an end
    std::vector<std::uint8_t> reached_;
};

}  // namespace laplacian_lines
