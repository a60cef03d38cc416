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

BlockMask bit_of(const Eigen::Array3i& node) {
    const Eigen::Array3i in_block = node.unaryExpr([](int i) { return i % kBlock; });
    return BlockMask(1) << ((in_block.z() * kBlock + in_block.y()) * kBlock + in_block.x());
}

/// By block; points are given by their first nodes, by block.
std::vector<BlockMask> reached_nodes(const GridGeometry& grid, const ReachedNodes& reached,
                                     const std::vector<BlockMask>& first_nodes) {
    std::vector<BlockMask> nodes(first_nodes.size(), 0);
    const std::size_t row = std::size_t(grid.blocks[0]);
    for_each_element(first_nodes.size(), [&](std::size_t block) {
        BlockMask parts[8] = {};
        reached.visit_all(first_nodes[block],
                          [&](int part, BlockMask mask) { parts[part] |= mask; });
        for (int part = 0; part < 8; ++part) {
            if (!parts[part]) continue;
            BlockMask& other =
                nodes[block + std::size_t(part & 1) + row * std::size_t(part >> 1 & 1) +
                      grid.sites() * std::size_t(part >> 2)];
            __atomic_fetch_or(&other, parts[part], __ATOMIC_RELAXED);
        }
    });
    return nodes;
}

}  // namespace

// Cubic splines reach four nodes from the second one on, quartic ones five.
const ReachedNodes kSpreadNodes(1, 4), kInterpolatedNodes(0, 5);

ReachedNodes::ReachedNodes(int offset, int count) {
    // All nodes that are first along an axis, and the step to the next along it.
    const BlockMask first[3] = {0x1111111111111111ull, 0x000f000f000f000full, 0xffffull};
    const int step[3] = {1, 4, 16};
    for (int axis = 0; axis < 3; ++axis)
        for (int shift = 0; shift < kBlock; ++shift)
            for (int i = shift + offset; i < shift + offset + count; ++i)
                masks_[axis][shift][i / kBlock] |= first[axis] << (i % kBlock * step[axis]);
}

GridGeometry::GridGeometry(const std::vector<Eigen::Vector3d>& points, double cell)
    : cell(cell), per_cell(1 / cell) {
    const Eigen::AlignedBox3d box = bounding_box(
        points.size(), [&](std::size_t i) -> const Eigen::Vector3d& { return points[i]; });
    // Half a cell more than the points reach, for rounding.
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
      first_nodes_(std::size_t(grid.block_count()), 0) {
    std::vector<std::uint32_t> block(positions.size());
    for_each_element(positions.size(), [&](std::size_t i) {
        const Eigen::Array3i node = grid.first_node(positions[i]);
        block[i] = std::uint32_t(block_of(grid, node));
        __atomic_fetch_or(&first_nodes_[block[i]], bit_of(node), __ATOMIC_RELAXED);
    });
    source_nodes_ = reached_nodes(grid, kSpreadNodes, first_nodes_);
    target_nodes_ = reached_nodes(grid, kInterpolatedNodes, first_nodes_);
    for (std::uint32_t b : block)
        ++starts_[b + 2];
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    for (std::size_t i = 0; i < positions.size(); ++i)
        order_[starts_[block[i] + 1]++] = std::uint32_t(i);
}

}  // namespace laplacian_lines
