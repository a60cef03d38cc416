// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "system/large_array.h"
#include "system/parallel.h"

namespace laplacian_lines {

/// Finds the pairs of boxes that meet: boxes along a space-filling curve, and a binary tree over
/// groups of four. Coordinates are local, from −1 to 1.
class NearPairs {
public:
    using Box = Eigen::AlignedBox3f;

    /// Of box_of(0), box_of(1), ...
    template <class BoxOf>
    NearPairs(std::size_t count, BoxOf box_of) : members_(large_array<Member>(count)) {
        auto order = large_array<std::pair<std::uint64_t, std::uint32_t>>(count);
        for_each_element(count, [&](std::size_t i) {
            const Box box = box_of(std::uint32_t(i));
            order[i] = {curve_place(box.center()), std::uint32_t(i)};
        });
        std::sort(order.begin(), order.end());
        for_each_element(count, [&](std::size_t i) {
            members_[i] = {box_of(order[i].second), order[i].second};
        });
        build_levels();
    }

    std::size_t group_count() const { return levels_.empty() ? 0 : levels_[0].size(); }

    /// Calls visit(a, b) for pairs of which the first that comes along the curve is in this group:
    /// for all groups, every pair once. Thread-safe.
    template <class Visit>
    void visit_pairs(std::size_t group, Visit visit) const {
        visit_below(levels_.size() - 1, 0, group, visit);
    }

private:
    struct Member {
        Box box;
        std::uint32_t number;
    };
    static constexpr std::size_t kGroup = 4;

    static std::uint64_t spread(std::uint64_t x) {
        x = (x | x << 32) & 0x1f00000000ffffu;
        x = (x | x << 16) & 0x1f0000ff0000ffu;
        x = (x | x << 8) & 0x100f00f00f00f00fu;
        x = (x | x << 4) & 0x10c30c30c30c30c3u;
        return (x | x << 2) & 0x1249249249249249u;
    }
    static std::uint64_t curve_place(const Eigen::Vector3f& point) {
        std::uint64_t place = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const float at = std::clamp((point[axis] + 1) / 2, 0.f, 1.f);
            place |= spread(std::uint64_t(at * float((1 << 21) - 1))) << axis;
        }
        return place;
    }

    void build_levels() {
        if (members_.empty()) return;
        levels_.emplace_back((members_.size() + kGroup - 1) / kGroup);
        for (std::size_t i = 0; i < members_.size(); ++i)
            levels_[0][i / kGroup].extend(members_[i].box);
        while (levels_.back().size() > 1) {
            std::vector<Box> next((levels_.back().size() + 1) / 2);
            for (std::size_t i = 0; i < levels_.back().size(); ++i)
                next[i / 2].extend(levels_.back()[i]);
            levels_.push_back(std::move(next));
        }
    }

    /// Passes over what lies before the group.
    template <class Visit>
    void visit_below(std::size_t level, std::size_t node, std::size_t group, Visit& visit) const {
        if ((node + 1) << level <= group) return;
        if (!levels_[level][node].intersects(levels_[0][group])) return;
        if (level == 0) return visit_groups(group, node, visit);
        for (std::size_t child = 2 * node;
             child < std::min(2 * node + 2, levels_[level - 1].size()); ++child)
            visit_below(level - 1, child, group, visit);
    }

    template <class Visit>
    void visit_groups(std::size_t first, std::size_t second, Visit& visit) const {
        const auto end_of = [&](std::size_t group) {
            return std::min(members_.size(), (group + 1) * kGroup);
        };
        for (std::size_t i = first * kGroup; i < end_of(first); ++i)
            for (std::size_t k = first == second ? i + 1 : second * kGroup; k < end_of(second); ++k)
                if (members_[i].box.intersects(members_[k].box))
                    visit(members_[i].number, members_[k].number);
    }

    std::vector<Member> members_;
    std::vector<std::vector<Box>> levels_;  // of groups, of pairs of these, ...
};

}  // namespace laplacian_lines
