// SPDX-License-Identifier: GPL-3.0-or-later
#include "sums/grid_points.h"

#include <Eigen/Geometry>

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

/// Sets the flags up to `reach` away from a set one along the axis with that stride.
void dilate(std::vector<std::uint8_t>& flags, int count, std::size_t stride, int reach) {
    const std::vector<std::uint8_t> before = flags;
    for (std::size_t i = 0; i < flags.size(); ++i) {
        if (!before[i]) continue;
        const int at = int(i / stride) % count;
        for (int j = std::max(0, at - reach); j <= std::min(count - 1, at + reach); ++j)
            flags[i + std::size_t(j) * stride - std::size_t(at) * stride] = 1;
    }
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
    : starts_(std::size_t(grid.block_count()) + 1, 0),
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
        ++starts_[b + 1];
    for (std::size_t b = 1; b < starts_.size(); ++b)
        starts_[b] += starts_[b - 1];
    for (std::size_t i = 0; i < positions.size(); ++i)
        order_[starts_[block[i]]++] = std::uint32_t(i);
    for (std::size_t b = starts_.size() - 1; b > 0; --b)
        starts_[b] = starts_[b - 1];
    starts_[0] = 0;
}

void GridPoints::restrict_to_targets(const GridGeometry& grid,
                                     const std::vector<Eigen::Vector3d>& positions,
                                     const std::vector<bool>& is_target, int reach) {
    std::vector<BlockMask> first_nodes(first_nodes_.size(), 0);
    std::vector<std::uint8_t> near(first_nodes.size(), 0);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (!is_target[i]) continue;
        const Eigen::Array3i node = grid.first_node(positions[i]);
        const std::size_t block = block_of(grid, node);
        first_nodes[block] |= bit_of(node);
        near[block] = 1;
    }
    target_nodes_ = reached_nodes(grid, kInterpolatedNodes, first_nodes);
    std::size_t stride = 1;
    for (int axis = 0; axis < 3; ++axis) {
        dilate(near, grid.blocks[axis], stride, reach);
        stride *= std::size_t(grid.blocks[axis]);
    }
    std::uint32_t kept = 0;
    for (std::size_t b = 0; b < near.size(); ++b) {
        const std::uint32_t begin = starts_[b], end = starts_[b + 1];
        starts_[b] = kept;
        if (!near[b]) first_nodes_[b] = 0;
        for (std::uint32_t i = begin; near[b] && i < end; ++i)
            order_[kept++] = order_[i];
    }
    starts_.back() = kept;
    source_nodes_ = reached_nodes(grid, kSpreadNodes, first_nodes_);
}

}  // namespace laplacian_lines
