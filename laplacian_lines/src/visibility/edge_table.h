// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "mesh/sides_by_edge.h"

namespace laplacian_lines {

/// The edges of triangles, each with all of these.
struct EdgeTable {
    /// A side of a triangle, or a part of one between vertices on it. A triangle on both sides of
    /// an edge has two, of both directions.
    struct Side {
        std::uint32_t triangle : 31;
        std::uint32_t
            is_reversed : 1;  ///< the triangle goes from the edge's second vertex to its first
    };
    struct Edge {
        std::uint32_t vertices[2];  ///< ascending
        std::uint32_t first_side;   ///< in `sides`, up to that of the next edge
    };

    std::vector<Edge> edges;  ///< and one more, behind the last
    std::vector<Side> sides;

    std::size_t edge_count() const { return edges.empty() ? 0 : edges.size() - 1; }
    std::size_t side_count(std::uint32_t edge) const {
        return edges[edge + 1].first_side - edges[edge].first_side;
    }
    const Side* sides_of(std::uint32_t edge) const { return &sides[edges[edge].first_side]; }
    bool is_border(std::uint32_t edge) const { return side_count(edge) == 1; }
};

/// Not yet grouped by edges.
struct LooseSide {
    Edge edge;
    std::uint32_t triangle;
    bool is_reversed;
};

inline LooseSide side_between(std::uint32_t from, std::uint32_t to, std::uint32_t triangle) {
    return {edge_between(from, to), triangle, from > to};
}

/// The sides side_of(i), i < count, by edges, in the order of their vertices, then of the
/// triangles, once each.
template <class SideOf>
EdgeTable gather_edges(std::size_t count, std::size_t vertices, SideOf side_of) {
    const auto parts = visit_edges<EdgeTable>(
        count, vertices, [&](std::uint32_t i) { return side_of(i).edge; },
        [&](const std::uint32_t* begin, const std::uint32_t* end, EdgeTable& part) {
            const auto first = std::uint32_t(part.sides.size());
            const Edge edge = side_of(*begin).edge;
            part.edges.push_back({{edge[0], edge[1]}, first});
            for (const std::uint32_t* i = begin; i != end; ++i)
                part.sides.push_back({side_of(*i).triangle, side_of(*i).is_reversed});
            const auto key = [](const EdgeTable::Side& side) {
                return std::uint32_t(side.triangle) << 1 | side.is_reversed;
            };
            std::sort(part.sides.begin() + first, part.sides.end(),
                      [&](const auto& a, const auto& b) { return key(a) < key(b); });
            const auto last =
                std::unique(part.sides.begin() + first, part.sides.end(),
                            [&](const auto& a, const auto& b) { return key(a) == key(b); });
            part.sides.erase(last, part.sides.end());
        });
    EdgeTable table;
    for (const EdgeTable& part : parts) {
        const auto first = std::uint32_t(table.sides.size());
        for (EdgeTable::Edge edge : part.edges) {
            edge.first_side += first;
            table.edges.push_back(edge);
        }
        table.sides.insert(table.sides.end(), part.sides.begin(), part.sides.end());
    }
    table.edges.push_back({{0, 0}, std::uint32_t(table.sides.size())});
    return table;
}

}  // namespace laplacian_lines
