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

void SpatialTree::build(const std::vector<Eigen::Vector3d>& points,
                        std::vector<std::uint32_t>& order, std::uint32_t begin, std::uint32_t end) {
    Node node{{}, 0, kNoLeaf};
    for (std::uint32_t i = begin; i < end; ++i)
        node.box.extend(points[order[i]]);
    const std::size_t self = nodes_.size();
    if (end - begin <= kLeafSize) {
        node.leaf = std::uint32_t(leaves_.size());
        leaves_.push_back({begin, end, node.box});
        nodes_.push_back(node);
        return;
    }
    int axis;
    node.box.sizes().maxCoeff(&axis);
    // Whole leaves on the left keep all leaves but the last ones full.
    const std::uint32_t half_leaves = (end - begin) / 2 / kLeafSize;
    const std::uint32_t middle =
        half_leaves > 0 ? begin + half_leaves * kLeafSize : begin + (end - begin) / 2;
    std::nth_element(
        order.begin() + begin, order.begin() + middle, order.begin() + end,
        [&](std::uint32_t i, std::uint32_t j) {
            return points[i][axis] != points[j][axis] ? points[i][axis] < points[j][axis] : i < j;
        });
    nodes_.push_back(node);
    build(points, order, begin, middle);
    nodes_[self].right = std::uint32_t(nodes_.size());
    build(points, order, middle, end);
}

}  // namespace laplacian_lines
