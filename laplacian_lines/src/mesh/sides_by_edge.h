// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"
#include "system/buckets.h"

namespace laplacian_lines {

/// Two vertices, ascending.
using Edge = std::array<std::uint32_t, 2>;

inline Edge edge_between(std::uint32_t a, std::uint32_t b) {
    return {std::min(a, b), std::max(a, b)};
}

/// Side 3 t + k of triangles runs from corner k of triangle t to the next.
inline std::uint32_t begin_of(const std::vector<Triangle>& triangles, std::uint32_t side) {
    return triangles[side / 3][side % 3];
}
inline std::uint32_t end_of(const std::vector<Triangle>& triangles, std::uint32_t side) {
    return triangles[side / 3][(side + 1) % 3];
}
inline Edge edge_of(const std::vector<Triangle>& triangles, std::uint32_t side) {
    return edge_between(begin_of(triangles, side), end_of(triangles, side));
}
/// Whether the triangles of two sides of an edge have one orientation: sides run opposite ways.
inline bool have_one_orientation(const std::vector<Triangle>& triangles, std::uint32_t side,
                                 std::uint32_t other) {
    return begin_of(triangles, side) != begin_of(triangles, other);
}
/// The sides of the same triangle after and before it.
inline std::uint32_t next_side(std::uint32_t side) {
    return side % 3 == 2 ? side - 2 : side + 1;
}
inline std::uint32_t previous_side(std::uint32_t side) {
    return side % 3 == 0 ? side + 2 : side - 1;
}

/// Some sides, sorted by the smaller vertex of their edges, then by the larger one, then by number.
struct SidesByEdge {
    struct Side {
        std::uint32_t larger, number;  // the vertex, and the side itself
        bool operator<(const Side& other) const {
            return larger != other.larger ? larger < other.larger : number < other.number;
        }
    };
    std::vector<Side> sides;
    std::vector<std::uint32_t> begins;  ///< in `sides`, by smaller vertex - first, and an end

    /// The smaller vertices are `vertices` in number from `first` on. Buckets come first, since
    /// few sides share a vertex, however many there are.
    template <class EdgeOf>
    SidesByEdge(const std::uint32_t* begin, const std::uint32_t* end, std::size_t first,
                std::size_t vertices, EdgeOf edge_of)
        : sides(std::size_t(end - begin)), begins(vertices + 2) {
        for (const std::uint32_t* side = begin; side != end; ++side)
            ++begins[edge_of(*side)[0] - first + 2];
        std::partial_sum(begins.begin(), begins.end(), begins.begin());
        // filling moves each begin, which is one place further on until then, to the next
        for (const std::uint32_t* side = begin; side != end; ++side) {
            const auto [smaller, larger] = edge_of(*side);
            sides[begins[smaller - first + 1]++] = {larger, *side};
        }
        for (std::size_t v = 0; v < vertices; ++v)
            std::sort(sides.begin() + begins[v], sides.begin() + begins[v + 1]);
    }

    /// Writes the numbers to `numbers`, in order, and calls visit(begin, end) there for each edge.
    template <class Visit>
    void visit_edges(std::uint32_t* numbers, Visit visit) const {
        for (std::size_t v = 0; v + 2 < begins.size(); ++v)
            for (std::uint32_t from = begins[v], to = from; from < begins[v + 1]; from = to) {
                for (; to < begins[v + 1] && sides[to].larger == sides[from].larger; ++to)
                    numbers[to] = sides[to].number;
                visit(numbers + from, numbers + to);
            }
    }
};

/// Gathers the sides 0 <= i < count that lie on the same edge_of(i), between `vertices`: calls
/// visit(begin, end, found) with the sides of each edge, ascending. Threads share the edges by
/// their smaller vertices; each part visits its edges in ascending order and fills one element of
/// the result, whose elements are in the order of the edges.
template <class Found, class EdgeOf, class Visit>
std::vector<Found> visit_edges(std::size_t count, std::size_t vertices, EdgeOf edge_of,
                               Visit visit) {
    constexpr std::size_t kSidesOfPart = 1024;  // few enough for the cache
    const std::size_t parts = count / kSidesOfPart + 1;
    const auto part_of = [&](std::uint32_t side) { return edge_of(side)[0] * parts / vertices; };
    const auto first_of = [&](std::size_t part) { return (part * vertices + parts - 1) / parts; };
    std::vector<Found> found(parts);
    const auto visit_part = [&](std::size_t part, std::uint32_t* begin, std::uint32_t* end) {
        const std::size_t first = first_of(part);
        const SidesByEdge sides(begin, end, first, first_of(part + 1) - first, edge_of);
        sides.visit_edges(begin, [&](const std::uint32_t* from, const std::uint32_t* to) {
            visit(from, to, found[part]);
        });
    };
    sort_in_buckets(count, parts, part_of).for_each(visit_part);
    return found;
}

}  // namespace laplacian_lines
