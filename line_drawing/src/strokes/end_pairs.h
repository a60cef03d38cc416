// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace line_drawing {

constexpr std::size_t kNoEnd = std::size_t(-1);

/// For each end of lines the end that continues it, or kNoEnd. cost(a, b), a < b, is a
/// std::optional<double>: nothing if these ends do not continue each other; the cheapest pairs are
/// made first. `positions`: ends 2i and 2i + 1 are those of line i. All ends within `reach` of each
/// other are asked for, and some that are farther apart.
template <class Cost>
std::vector<std::size_t> pair_ends(const std::vector<Eigen::Vector2d>& positions, double reach,
                                   Cost cost) {
    using Cell = std::array<std::int64_t, 2>;
    std::map<Cell, std::vector<std::size_t>> cells;
    std::vector<std::pair<double, std::array<std::size_t, 2>>> found;
    for (std::size_t b = 0; b < positions.size(); ++b) {
        const Cell at = {std::int64_t(std::floor(positions[b].x() / reach)),
                         std::int64_t(std::floor(positions[b].y() / reach))};
        for (const std::int64_t dx : {-1, 0, 1})
            for (const std::int64_t dy : {-1, 0, 1}) {
                const auto cell = cells.find({at[0] + dx, at[1] + dy});
                if (cell == cells.end()) continue;
                for (const std::size_t a : cell->second)
                    if (const std::optional<double> price = cost(a, b))
                        found.push_back({*price, {a, b}});
            }
        cells[at].push_back(b);
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::size_t> partners(positions.size(), kNoEnd);
    for (const auto& [price, pair] : found)
        if (partners[pair[0]] == kNoEnd && partners[pair[1]] == kNoEnd) {
            partners[pair[0]] = pair[1];
            partners[pair[1]] = pair[0];
        }
    return partners;
}

/// Calls visit(way, is_ring) for each chain of lines, with the ends that it enters them by: open
/// chains from an end that nothing continues, then rings. `partners`: see pair_ends().
template <class Visit>
void for_each_chain_of_ends(const std::vector<std::size_t>& partners, Visit visit) {
    std::vector<bool> is_done(partners.size());
    for (const bool is_ring : {false, true})
        for (std::size_t first = 0; first < partners.size(); ++first) {
            if (is_done[first] || (!is_ring && partners[first] != kNoEnd)) continue;
            std::vector<std::size_t> way;
            for (std::size_t e = first; e != kNoEnd && !is_done[e]; e = partners[e ^ 1]) {
                is_done[e] = is_done[e ^ 1] = true;
                way.push_back(e);
            }
            visit(way, is_ring);
        }
}

}  // namespace line_drawing
