// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "system/buckets.h"
#include "system/large_array.h"
#include "system/parallel.h"

namespace laplacian_lines {

/// Numbers of seven bits with room for those of the other axes between them.
template <int Dim>
std::array<std::uint64_t, 128> spread_numbers() {
    std::array<std::uint64_t, 128> table{};
    for (std::uint64_t x = 0; x < 128; ++x)
        for (int bit = 0; bit < 7; ++bit)
            table[x] |= (x >> bit & 1) << (bit * Dim);
    return table;
}

/// Numbers from 0 on in the order of their points along a curve that fills a box (G. Morton, 1966),
/// so that those near each other are mostly near each other in space. Points beside the box are
/// taken for some at its border.
template <int Dim, class PointOf>
std::vector<std::uint32_t> order_along_curve(std::size_t count,
                                             const Eigen::AlignedBox<float, Dim>& box,
                                             PointOf point_of) {
    constexpr int kBits = 21;
    const int bucket_bits = count > kBlockElements ? 12 : 0;
    const auto table = spread_numbers<Dim>();
    const auto spread = [&](std::uint64_t x) {
        std::uint64_t result = 0;
        for (int bit = 0; bit < kBits; bit += 7)  // seven bits at a time
            result |= table[x >> bit & 127] << (bit * Dim);
        return result;
    };
    auto places = large_array<std::uint64_t>(count);
    for_each_element(count, [&](std::size_t i) {
        const Eigen::Matrix<float, Dim, 1> point = point_of(std::uint32_t(i));
        for (int axis = 0; axis < Dim; ++axis) {
            const float share = (point[axis] - box.min()[axis]) / box.sizes()[axis];
            const float at = share > 0 ? std::min(share, 1.f) : 0;  // also what is not a number
            places[i] |= spread(std::uint64_t(at * float((1 << kBits) - 1))) << axis;
        }
    });
    Buckets buckets = sort_in_buckets(count, std::size_t(1) << bucket_bits, [&](std::uint32_t i) {
        return places[i] >> (Dim * kBits - bucket_bits);
    });
    buckets.for_each([&](std::size_t, std::uint32_t* begin, std::uint32_t* end) {
        std::sort(begin, end, [&](std::uint32_t a, std::uint32_t b) {
            return places[a] != places[b] ? places[a] < places[b] : a < b;
        });
    });
    return std::move(buckets.numbers);
}

/// A box around local coordinates.
inline Eigen::AlignedBox3f local_box() {
    return {Eigen::Vector3f::Constant(-1), Eigen::Vector3f::Constant(1)};
}

/// A tree of the boxes of elements in such an order: each four that follow each other have one
/// together, each four of these, and so on. Thread-safe.
template <int Dim>
class BoxTree {
public:
    using Box = Eigen::AlignedBox<float, Dim>;

    BoxTree() = default;
    /// Holds box_of(i) for all i in `order`, which has to outlive the tree.
    template <class BoxOf>
    BoxTree(const std::vector<std::uint32_t>& order, BoxOf box_of) : order_(&order) {
        const auto add_level = [&](std::size_t size, auto box_of_node) {
            auto level = large_array<Box>(size);
            for_each_element(size, [&](std::size_t node) { level[node] = box_of_node(node); });
            levels_.push_back(std::move(level));
        };
        add_level(order.size(), [&](std::size_t i) { return box_of(order[i]); });
        while (levels_.back().size() > 1) {
            const std::vector<Box>& below = levels_.back();
            add_level((below.size() + kFan - 1) / kFan, [&](std::size_t node) {
                Box box;
                for (std::size_t k = node * kFan; k < std::min(below.size(), (node + 1) * kFan);
                     ++k)
                    box.extend(below[k]);
                return box;
            });
        }
    }

    /// Calls visit(number) for the elements whose boxes meet one, until it returns false.
    template <class Visit>
    void visit(const Box& box, Visit visit) const {
        if (!is_empty() && levels_.back()[0].intersects(box))
            visit_nodes(top(), 0, box, 0, [&](std::size_t i) { return visit((*order_)[i]); });
    }

    /// Two parts of the tree whose boxes meet, or one twice.
    struct Pair {
        std::uint32_t nodes[2];
    };
    /// In which all pairs of elements are that meet, each once.
    std::vector<Pair> pairs() const {
        std::vector<Pair> all;
        if (is_empty()) return all;
        const std::size_t level = std::min(top(), kPairLevel);
        for (std::uint32_t node = 0; node < levels_[level].size(); ++node)
            visit_nodes(top(), 0, levels_[level][node], level, [&](std::size_t other) {
                if (other >= node) all.push_back({{node, std::uint32_t(other)}});
                return true;
            });
        return all;
    }
    /// Calls visit(i, k) for the places in the order of elements whose boxes meet, i < k.
    template <class Visit>
    void visit_pairs(const Pair& pair, Visit visit) const {
        visit_pairs(std::min(top(), kPairLevel), pair.nodes[0], pair.nodes[1], visit);
    }

private:
    static constexpr std::size_t kFan = 4;
    static constexpr std::size_t kPairLevel = 5;  // 1,024 elements

    bool is_empty() const { return levels_.empty() || levels_[0].empty(); }
    std::size_t top() const { return levels_.size() - 1; }
    std::size_t end_of(std::size_t node, std::size_t level) const {
        return std::min(levels_[level - 1].size(), (node + 1) * kFan);
    }

    /// Calls visit(node) for nodes of a level that meet a box, below one that does, until it
    /// returns false; returns whether it never has.
    template <class Visit>
    bool visit_nodes(std::size_t at, std::size_t node, const Box& box, std::size_t level,
                     const Visit& visit) const {
        if (at == level) return visit(node);
        for (std::size_t child = node * kFan; child < end_of(node, at); ++child)
            if (levels_[at - 1][child].intersects(box) &&
                !visit_nodes(at - 1, child, box, level, visit))
                return false;
        return true;
    }

    template <class Visit>
    void visit_pairs(std::size_t level, std::size_t a, std::size_t b, const Visit& visit) const {
        if (a != b && !levels_[level][a].intersects(levels_[level][b])) return;
        if (level == 0) {
            if (a != b) visit(a, b);
            return;
        }
        for (std::size_t i = a * kFan; i < end_of(a, level); ++i)
            if (a == b || levels_[level - 1][i].intersects(levels_[level][b]))
                for (std::size_t k = a == b ? i : b * kFan; k < end_of(b, level); ++k)
                    visit_pairs(level - 1, i, k, visit);
    }

    const std::vector<std::uint32_t>* order_ = nullptr;
    std::vector<std::vector<Box>> levels_;  // of elements, of four of these, ...
};

}  // namespace laplacian_lines
