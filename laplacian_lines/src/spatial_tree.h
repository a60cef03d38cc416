// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace laplacian_lines {

/// A balanced kd-tree over points, with leaves of at most 32 points that are neighbours in space.
class SpatialTree {
public:
    static constexpr std::uint32_t kLeafSize = 32;

    struct Leaf {
        std::uint32_t begin, end;  ///< range of points, in the tree's order
        Eigen::AlignedBox3d box;
    };

    /// `order` becomes the tree's order: order[i] is the index of its i-th point.
    SpatialTree(const std::vector<Eigen::Vector3d>& points, std::vector<std::uint32_t>& order);

    const std::vector<Leaf>& leaves() const { return leaves_; }

    /// Calls visit(leaf) for every leaf whose box is within `radius` of `box`.
    template <class Visit>
    void visit_leaves(const Eigen::AlignedBox3d& box, double radius, Visit visit) const {
        visit_node(0, box, radius * radius, visit);
    }

private:
    struct Node {
        Eigen::AlignedBox3d box;
        std::uint32_t right;  // the left child follows its parent
        std::uint32_t leaf;   // kNoLeaf for inner nodes
    };
    static constexpr std::uint32_t kNoLeaf = 0xffffffffu;

    void build(const std::vector<Eigen::Vector3d>& points, std::vector<std::uint32_t>& order,
               std::uint32_t begin, std::uint32_t end);

    template <class Visit>
    void visit_node(std::uint32_t n, const Eigen::AlignedBox3d& box, double squared_radius,
                    Visit& visit) const {
        const Node& node = nodes_[n];
        if (node.box.squaredExteriorDistance(box) > squared_radius) return;
        if (node.leaf != kNoLeaf) return visit(leaves_[node.leaf]);
        visit_node(n + 1, box, squared_radius, visit);
        visit_node(node.right, box, squared_radius, visit);
    }

    std::vector<Node> nodes_;
    std::vector<Leaf> leaves_;
};

}  // namespace laplacian_lines
