// SPDX-License-Identifier: GPL-3.0-or-later
#include "sums/grid_points.h"

#include <Eigen/Geometry>
#include <numeric>

#include "mesh/bounding_box.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

std::size_t block_of(const GridGeometry& grid, const Eigen::Array3i& node) {
    return (std::size_t(node.z() / kBlock) * std::size_t(grid.blocks[1]) +
            std::size_t(node.y() / kBlock)) *
               std::size_t(grid.blocks[0]) +
           std::size_t(node.x() / kBlock);
}

}  // namespace

GridGeometry::GridGeometry(const std::vector<Eigen::Vector3d>& points, double cell)
    : cell(cell), per_cell(1 / cell) {
    const Eigen::AlignedBox3d box = bounding_box(points);
    // With half a cell more than needed, for rounding.
    origin = box.min() - Eigen::Vector3d::Constant(2.5 * cell);
    // Slabs across the longest axis are small, and few of them are in memory.
    box.sizes().maxCoeff(&axes[2]);
    for (int axis = 0; axis < 3; ++axis) {
        if (axis < 2) axes[axis] = (axes[2] + 1 + axis) % 3;
        blocks[axis] = int((box.sizes()[axes[axis]] / cell + 5) / kBlock) + 1;
    }
}

GridPoints::GridPoints(const GridGeometry& grid, const std::vector<Eigen::Vector3d>& positions)
    : starts_(std::size_t(grid.block_count()) + 2, 0),
      order_(positions.size()),
      reached_(std::size_t(grid.block_count()), 0) {
    std::vector<std::uint32_t> block(positions.size());
    for_each_element(positions.size(), [&](std::size_t i) {
        block[i] = std::uint32_t(block_of(grid, grid.first_node(positions[i])));
    });
    for (std::uint32_t b : block)
        ++starts_[b + 2];
    for (std::size_t b = 0; b < reached_.size(); ++b)
        for (int part = 0; part < 8 && starts_[b + 2] > 0; ++part)
            reached_[b + grid.step_to(part)] = 1;
    // until points are filled in, the start of a block is at the place of the next one
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    for (std::size_t i = 0; i < positions.size(); ++i)
        order_[starts_[block[i] + 1]++] = std::uint32_t(i);
}

}  // namespace laplacian_lines
