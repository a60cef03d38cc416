// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid_points.h"

#include <Eigen/Geometry>
#include <cmath>

#include "grid_kernels.h"

namespace laplacian_lines {
namespace {

std::size_t block_of(const GridGeometry& grid, const Eigen::Array3i& node) {
    return (std::size_t(node.z() / kBlock) * std::size_t(grid.blocks[1]) +
            std::size_t(node.y() / kBlock)) *
               std::size_t(grid.blocks[0]) +
           std::size_t(node.x() / kBlock);
}

void mark(const GridGeometry& grid, const ReachedNodes& reached, const Eigen::Array3i& node,
          std::vector<BlockMask>& masks) {
    BlockMask* block = &masks[block_of(grid, node)];
    const std::size_t row = std::size_t(grid.blocks[0]);
    reached.visit_parts(node, [&](int part, BlockMask nodes) {
        block[std::size_t(part & 1) + row * std::size_t(part >> 1 & 1) +
              grid.columns() * std::size_t(part >> 2)] |= nodes;
    });
}

/// Sets each flag that has a set one at most `reach` away along the axis with that stride.
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
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : points)
        box.extend(p);
    // Half a cell more than the points reach, for rounding.
    origin = box.min() - Eigen::Vector3d::Constant(2.5 * cell);
    // Layers across the longest axis are small, and few of them are in memory.
    box.sizes().maxCoeff(&axes[2]);
    for (int axis = 0; axis < 3; ++axis) {
        if (axis < 2) axes[axis] = (axes[2] + 1 + axis) % 3;
        blocks[axis] = int((box.sizes()[axes[axis]] / cell + 5) / kBlock) + 1;
    }
}

GridPoints::GridPoints(const GridGeometry& grid, const std::vector<Eigen::Vector3d>& positions)
    : starts_(std::size_t(grid.block_count()) + 1, 0),
      order_(positions.size()),
      source_nodes_(std::size_t(grid.block_count()), 0),
      target_nodes_(std::size_t(grid.block_count()), 0) {
    std::vector<std::uint32_t> block(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const Eigen::Array3i node = grid.first_node(positions[i]);
        block[i] = std::uint32_t(block_of(grid, node));
        ++starts_[block[i] + 1];
        mark(grid, kSpreadNodes, node, source_nodes_);
        mark(grid, kInterpolatedNodes, node, target_nodes_);
    }
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
    target_nodes_.assign(source_nodes_.size(), 0);
    source_nodes_.assign(source_nodes_.size(), 0);
    std::vector<std::uint8_t> near(source_nodes_.size(), 0);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (!is_target[i]) continue;
        const Eigen::Array3i node = grid.first_node(positions[i]);
        near[block_of(grid, node)] = 1;
        mark(grid, kInterpolatedNodes, node, target_nodes_);
    }
    std::size_t stride = 1;
    for (int axis = 0; axis < 3; ++axis) {
        dilate(near, grid.blocks[axis], stride, reach);
        stride *= std::size_t(grid.blocks[axis]);
    }
    std::uint32_t kept = 0;
    for (std::size_t b = 0; b < near.size(); ++b) {
        const std::uint32_t begin = starts_[b], end = starts_[b + 1];
        starts_[b] = kept;
        for (std::uint32_t i = begin; near[b] && i < end; ++i) {
            order_[kept++] = order_[i];
            mark(grid, kSpreadNodes, grid.first_node(positions[order_[i]]), source_nodes_);
        }
    }
    starts_.back() = kept;
}

}  // namespace laplacian_lines
