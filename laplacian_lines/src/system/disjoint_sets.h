// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace laplacian_lines {

/// Sets of the numbers below n, each with its smallest as root.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t n) : parent_(n) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }

    std::uint32_t root(std::uint32_t number) {
        while (parent_[number] != number)
            number = parent_[number] = parent_[parent_[number]];
        return number;
    }
    /// Returns the root.
    std::uint32_t unite(std::uint32_t a, std::uint32_t b) {
        const auto [smaller, larger] = std::minmax({root(a), root(b)});
        return parent_[larger] = smaller;
    }
    /// The root of each number; leaves the sets empty.
    std::vector<std::uint32_t> take_roots() {
        for (std::uint32_t number = 0; number < parent_.size(); ++number)
            parent_[number] = root(number);
        return std::move(parent_);
    }

private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace laplacian_lines
