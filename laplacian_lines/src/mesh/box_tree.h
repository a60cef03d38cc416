// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "mesh/curve_order.h"
#include "system/large_array.h"
#include "system/parallel.h"

namespace laplacian_lines {

/// Holds all local coordinates.
inline Eigen::AlignedBox3f local_box() {
    return {Eigen::Vector3f::Constant(-1), Eigen::Vector3f::Constant(1)};
}

/// Around a box in local coordinates, with room of `reach` and for the rounding of floats, which
/// is less than 1e-7 there.
inline Eigen::AlignedBox3f box_around(const Eigen::AlignedBox3d& box, double reach) {
    const Eigen::Vector3f more = Eigen::Vector3f::Constant(float(reach) + 1e-7f);
    return {box.min().cast<float>() - more, box.max().cast<float>() + more};
}

/// The same around a straight line.
inline Eigen::AlignedBox3f box_around(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                      double reach) {
    return box_around(Eigen::AlignedBox3d(a.cwiseMin(b), a.cwiseMax(b)), reach);
}

/// Four boxes, tested together. At first empty.
template <int Dim>
class FourBoxes {
    typedef float Lanes __attribute__((vector_size(16)));

public:
    using Box = Eigen::AlignedBox<float, Dim>;
    static constexpr unsigned kCount = 4;

    FourBoxes() {
        for (unsigned k = 0; k < kCount; ++k)
            set(k, Box());
    }
    void set(unsigned k, const Box& box) {
        for (int axis = 0; axis < Dim; ++axis) {
            low_[axis][k] = box.min()[axis];
            high_[axis][k] = box.max()[axis];
        }
    }
    Box box(unsigned k) const {
        Box box;
        for (int axis = 0; axis < Dim; ++axis) {
            box.min()[axis] = low_[axis][k];
            box.max()[axis] = high_[axis][k];
        }
        return box;
    }
    Box bounds() const {
        Box all = box(0);
        for (unsigned k = 1; k < kCount; ++k)
            all.extend(box(k));
        return all;
    }
    /// Bit k: that one meets `other`.
    unsigned meeting(const Box& other) const {
        typedef std::int32_t Bits __attribute__((vector_size(16)));
        Bits bits = {1, 2, 4, 8};
        for (int axis = 0; axis < Dim; ++axis)
            bits &= (low_[axis] <= Lanes{} + other.max()[axis]) &
                    (high_[axis] >= Lanes{} + other.min()[axis]);
        return unsigned(bits[0] | bits[1] | bits[2] | bits[3]);
    }

private:
    Lanes low_[Dim], high_[Dim];
};

/// A tree of boxes over elements in an order, with four children a node. Few boxes are looked at if
/// neighbours in the order are neighbours in space. Thread-safe.
template <int Dim>
class BoxTree {
public:
    using Box = Eigen::AlignedBox<float, Dim>;

    BoxTree() = default;
    /// Holds box_of(i) for all i in `order`.
    template <class BoxOf>
    BoxTree(std::vector<std::uint32_t> order, BoxOf box_of) : order_(std::move(order)) {
        const auto add_level = [&](std::size_t count, auto box_at) {
            auto level = large_array<Fours>((count + kFan - 1) / kFan);
            for_each_element(level.size(), [&](std::size_t node) {
                for (unsigned k = 0; k < std::min(kFan, count - node * kFan); ++k)
                    level[node].set(k, box_at(node * kFan + k));
            });
            levels_.push_back(std::move(level));
        };
        if (order_.empty()) return;
        add_level(order_.size(), [&](std::size_t i) { return box_of(order_[i]); });
        while (levels_.back().size() > 1) {
            const std::vector<Fours>& below = levels_.back();
            add_level(below.size(), [&](std::size_t node) { return below[node].bounds(); });
        }
    }
    /// Holds box_of(i) for these numbers i, see order_along_curve().
    template <class BoxOf>
    static BoxTree along_curve(std::vector<std::uint32_t> numbers, const Box& bounds,
                               BoxOf box_of) {
        std::vector<std::uint32_t> order = order_along_curve<Dim>(
            numbers.size(), bounds, [&](std::uint32_t i) -> Eigen::Matrix<float, Dim, 1> {
                return box_of(numbers[i]).center();
            });
        for (std::uint32_t& i : order)
            i = numbers[i];
        return {std::move(order), box_of};
    }
    /// For the numbers below `count`.
    template <class BoxOf>
    static BoxTree along_curve(std::size_t count, const Box& bounds, BoxOf box_of) {
        return along_curve(numbers_up_to(count), bounds, box_of);
    }

    const std::vector<std::uint32_t>& order() const { return order_; }

    /// Calls visit(number) for the elements whose boxes meet `box`, until a call returns false;
    /// `visit` may return nothing, and may shrink `box`. Returns whether no call returned false.
    template <class Visit>
    bool visit(const Box& box, Visit visit) const {
        return levels_.empty() || visit_nodes(top(), 0, box, 0, [&](std::size_t i) {
                   if constexpr (std::is_void_v<decltype(visit(order_[i]))>)
                       return visit(order_[i]), true;
                   else
                       return visit(order_[i]);
               });
    }

    /// Two subtrees whose boxes meet, or the same one twice.
    struct Pair {
        std::uint32_t nodes[2];
    };
    /// Pairs that together hold each pair of elements that meet once.
    std::vector<Pair> pairs() const {
        std::vector<Pair> all;
        if (levels_.empty()) return all;
        const std::size_t level = std::min(top(), kPairLevel);
        const std::vector<Fours>& nodes = levels_[level - 1];
        for (std::uint32_t node = 0; node < nodes.size(); ++node)
            visit_nodes(top(), 0, nodes[node].bounds(), level, [&](std::size_t other) {
                if (other >= node) all.push_back({{node, std::uint32_t(other)}});
                return true;
            });
        return all;
    }
    /// Calls visit(i, k), i < k, for places in the order whose elements' boxes meet.
    template <class Visit>
    void visit_pairs(const Pair& pair, Visit visit) const {
        const std::size_t level = std::min(top(), kPairLevel);
        const auto [a, b] = pair.nodes;
        visit_pairs(level, a, b, levels_[level - 1][b].bounds(), visit);
    }

private:
    using Fours = FourBoxes<Dim>;
    static constexpr std::size_t kFan = Fours::kCount;
    static constexpr std::size_t kPairLevel = 5;  // 1,024 elements

    // Level 0 is elements; nodes of level n + 1 have the boxes of levels_[n].
    std::size_t top() const { return levels_.size(); }

    /// Calls visit(node) for the descendants of a node on a level that meet a box, until a call
    /// returns false. Returns whether none did.
    template <class Visit>
    bool visit_nodes(std::size_t at, std::size_t node, const Box& box, std::size_t level,
                     const Visit& visit) const {
        if (at == level) return visit(node);
        const unsigned near = levels_[at - 1][node].meeting(box);
        for (unsigned k = 0; near >> k; ++k)
            if ((near >> k & 1) && !visit_nodes(at - 1, node * kFan + k, box, level, visit))
                return false;
        return true;
    }

    /// As visit_pairs(), for two nodes that meet, or the same one twice.
    template <class Visit>
    void visit_pairs(std::size_t level, std::size_t a, std::size_t b, const Box& box_of_b,
                     const Visit& visit) const {
        const Fours &of_a = levels_[level - 1][a], &of_b = levels_[level - 1][b];
        const unsigned near_b = of_a.meeting(box_of_b);
        for (unsigned i = 0; near_b >> i; ++i) {
            if (!(near_b >> i & 1)) continue;
            const unsigned near = of_b.meeting(of_a.box(i));
            for (unsigned k = a == b ? i : 0; near >> k; ++k) {
                if (!(near >> k & 1)) continue;
                const std::size_t first = a * kFan + i, second = b * kFan + k;
                if (level > 1)
                    visit_pairs(level - 1, first, second, of_b.box(k), visit);
                else if (first != second)
                    visit(first, second);
            }
        }
    }

    std::vector<std::uint32_t> order_;
    std::vector<std::vector<Fours>> levels_;
};

}  // namespace laplacian_lines
