// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace benchmarks {

/// Points where lines cross edges of a mesh, each found once an edge through a hash map, and
/// joined to lines by the plain ways to draw them. Lines end where only one other is joined.
template <class Point>
class JoinedCrossings {
public:
    void clear() {
        crossings_.clear();
        crossing_of_edge_.clear();
    }

    /// The number of the crossing on the edge between two vertices; if it is new, `make(low, high)`
    /// gives the point.
    template <class Make>
    std::uint32_t on_edge(std::uint32_t a, std::uint32_t b, const Make& make) {
        const auto [low, high] = std::minmax(a, b);
        const auto [found, is_new] = crossing_of_edge_.try_emplace(
            std::uint64_t(low) << 32 | high, std::uint32_t(crossings_.size()));
        if (is_new) crossings_.push_back({make(low, high)});
        return found->second;
    }

    void join(std::uint32_t a, std::uint32_t b) {
        add_neighbour(a, b);
        add_neighbour(b, a);
    }

    /// Calls begin() at each line, open ones first, then add(point) for its points; of closed ones
    /// the first comes again at the end. Once, until it is cleared.
    template <class Begin, class Add>
    void for_each_line(const Begin& begin, const Add& add) {
        for (const bool loops : {false, true})
            for (std::uint32_t c = 0; c < crossings_.size(); ++c)
                if (!crossings_[c].visited && (loops || crossings_[c].neighbours[1] == kNone)) {
                    begin();
                    follow(c, add);
                }
    }

private:
    static constexpr std::uint32_t kNone = 0xffffffffu;
    struct Crossing {
        Point point;
        std::uint32_t neighbours[2] = {kNone, kNone};
        bool visited = false;
    };

    void add_neighbour(std::uint32_t crossing, std::uint32_t other) {
        auto& neighbours = crossings_[crossing].neighbours;
        neighbours[neighbours[0] == kNone ? 0 : 1] = other;
    }

    template <class Add>
    void follow(std::uint32_t first, const Add& add) {
        for (std::uint32_t before = kNone, here = first; here != kNone;) {
            Crossing& c = crossings_[here];
            add(c.point);
            if (c.visited) return;  // once round
            c.visited = true;
            const std::uint32_t next = c.neighbours[c.neighbours[0] == before ? 1 : 0];
            before = here;
            here = next;
        }
    }

    std::unordered_map<std::uint64_t, std::uint32_t> crossing_of_edge_;
    std::vector<Crossing> crossings_;
};

}  // namespace benchmarks
