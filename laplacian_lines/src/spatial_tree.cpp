// SPDX-License-Identifier: GPL-3.0-or-later
#include "spatial_tree.h"

#include <algorithm>
#include <numeric>

namespace laplacian_lines {

SpatialTree::SpatialTree(const std::vector<Eigen::Vector3d>& points,
                         std::vector<std::uint32_t>& order) {
    order.resize(points.size());
    std::iota(order.begin(), order.end(), 0u);
    if (!points.empty()) build(points, order, 0, std::uint32_t(points.size()));
}

namespace {

using Points = std::vector<Eigen::Vector3d>;
using Order = std::vector<std::uint32_t>;

/// Puts the points below the middle-th along the box's longest axis before it.
void split(const Points& points, Order& order, std::uint32_t begin, std::uint32_t middle,
           std::uint32_t end, const Eigen::AlignedBox3d& box) {
    int axis;
    box.sizes().maxCoeff(&axis);
    std::nth_element(
        order.begin() + begin, order.begin() + middle, order.begin() + end,
        [&](std::uint32_t i, std::uint32_t j) {
            return points[i][axis] != points[j][axis] ? points[i][axis] < points[j][axis] : i < j;
        });
}

Eigen::AlignedBox3d bounding_box(const Points& points, const Order& order, std::uint32_t begin,
                                 std::uint32_t end) {
    Eigen::AlignedBox3d box;
    for (std::uint32_t i = begin; i < end; ++i)
        box.extend(points[order[i]]);
    return box;
}

/// Goes on splitting inside a leaf, so that also there neighbours share cache lines.
void order_leaf(const Points& points, Order& order, std::uint32_t begin, std::uint32_t end) {
    if (end - begin <= 2) return;
    const std::uint32_t middle = begin + (end - begin) / 2;
    split(points, order, begin, middle, end, bounding_box(points, order, begin, end));
    order_leaf(points, order, begin, middle);
    order_leaf(points, order, middle, end);
}

}  // namespace

void SpatialTree::build(const Points& points, Order& order, std::uint32_t begin,
                        std::uint32_t end) {
    Node node{bounding_box(points, order, begin, end), 0, kNoLeaf};
    const std::size_t self = nodes_.size();
    if (end - begin <= kLeafSize) {
        order_leaf(points, order, begin, end);
        node.leaf = std::uint32_t(leaves_.size());
        leaves_.push_back({begin, end, node.box});
        nodes_.push_back(node);
        return;
    }
    // Whole leaves on the left keep all leaves but the last ones full.
    const std::uint32_t half_leaves = (end - begin) / 2 / kLeafSize;
    const std::uint32_t middle =
        half_leaves > 0 ? begin + half_leaves * kLeafSize : begin + (end - begin) / 2;
    split(points, order, begin, middle, end, node.box);
    nodes_.push_back(node);
    build(points, order, begin, middle);
    nodes_[self].right = std::uint32_t(nodes_.size());
    build(points, order, middle, end);
}

}  // namespace laplacian_lines
