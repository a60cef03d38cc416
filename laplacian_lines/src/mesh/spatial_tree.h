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

    /// Of at least one point. `order` becomes the tree's order: order[i] is the index of its i-th
    /// point.
    SpatialTree(const std::vector<Eigen::Vector3d>& points, std::vector<std::uint32_t>& order);

    const std::vector<Leaf>& leaves() const { return leaves_; }

    /// Calls visit(leaf) for every leaf whose box is within `radius` of `box`, give or take a
    /// rounding error of floats.
    template <class Visit>
    void visit_leaves(const Eigen::AlignedBox3d& box, double radius, Visit visit) const {
        visit_node(0, FloatBox(box), float(radius * radius * (1 + 1e-6)), visit);
    }

private:
    struct alignas(16) FloatBox {
        typedef float Float4 __attribute__((vector_size(16)));

        FloatBox() = default;
        explicit FloatBox(const Eigen::AlignedBox3d& box);

        float squared_distance(const FloatBox& other) const {
            const Float4 below = low - other.high, above = other.low - high, none = {};
            Float4 gap = below > above ? below : above;
            gap = gap > none ? gap : none;
            gap *= gap;
            return gap[0] + gap[1] + gap[2];
        }

        Float4 low{}, high{};  // the last of each is 0
    };
    struct Node {
        FloatBox box;
        std::uint32_t right;  // the left child follows its parent
        std::uint32_t leaf;   // kNoLeaf for inner nodes
    };
    static constexpr std::uint32_t kNoLeaf = 0xffffffffu;

    class Builder;

    template <class Visit>
    void visit_node(std::uint32_t n, const FloatBox& box, float squared_radius,
                    Visit& visit) const {
        const Node& node = nodes_[n];
        if (node.box.squared_distance(box) > squared_radius) return;
        if (node.leaf != kNoLeaf) return visit(leaves_[node.leaf]);
        visit_node(n + 1, box, squared_radius, visit);
        visit_node(node.right, box, squared_radius, visit);
    }

    std::vector<Node> nodes_;
    std::vector<Leaf> leaves_;
};

}  // namespace laplacian_lines
