// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"
#include "system/buckets.h"
#include "system/large_array.h"

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
    std::uint32_t vertices[2];  // ascending
    std::uint32_t triangle;
    bool is_reversed;
};

inline LooseSide side_between(std::uint32_t from, std::uint32_t to, std::uint32_t triangle) {
    return {{std::min(from, to), std::max(from, to)}, triangle, from > to};
}

/// The sides side_of(i), i < count, by edges, in the order of their vertices, then of the
/// triangles, once each.
template <class SideOf>
void gather_edges(std::size_t count, SideOf side_of, std::size_t vertices, EdgeTable& table) {
    struct Key {
        std::uint32_t vertex, side, number;  // the edge's second vertex
        bool operator<(const Key& other) const {
            return vertex != other.vertex ? vertex < other.vertex : side < other.side;
        }
        bool operator==(const Key& other) const {
            return vertex == other.vertex && side == other.side;
        }
    };
    constexpr std::size_t kBucket = 1024;
    const std::size_t bucket_count = count / kBucket + 1;
    const auto bucket_of = [&](std::size_t vertex) { return vertex * bucket_count / vertices; };
    Buckets buckets = sort_in_buckets(
        count, bucket_count, [&](std::uint32_t i) { return bucket_of(side_of(i).vertices[0]); });
    std::vector<std::uint32_t> first_edges(bucket_count + 1), first_sides(bucket_count + 1);
    buckets.for_each([&](std::size_t bucket, std::uint32_t* begin, std::uint32_t* end) {
        // first by the edges' first vertices, at each of which are but a few
        const std::size_t first = (bucket * vertices + bucket_count - 1) / bucket_count,
                          last = ((bucket + 1) * vertices + bucket_count - 1) / bucket_count;
        std::vector<std::uint32_t> ends(last - first + 2);
        for (const std::uint32_t* i = begin; i != end; ++i)
            ++ends[side_of(*i).vertices[0] - first + 2];
        std::partial_sum(ends.begin(), ends.end(), ends.begin());
        std::vector<Key> keys(std::size_t(end - begin));
        for (const std::uint32_t* i = begin; i != end; ++i) {
            const LooseSide side = side_of(*i);
            keys[ends[side.vertices[0] - first + 1]++] = {side.vertices[1],
                                                          2 * side.triangle + side.is_reversed, *i};
        }
        std::uint32_t edge_count = 0, side_count = 0;
        for (std::size_t v = first; v < last; ++v) {
            const auto from = keys.begin() + ends[v - first],
                       to = keys.begin() + ends[v - first + 1];
            std::sort(from, to);
            for (auto key = from; key != to; ++key) {
                if (key != from && *key == key[-1]) continue;
                edge_count += key == from || key->vertex != key[-1].vertex;
                begin[side_count++] = key->number;
            }
        }
        first_edges[bucket] = edge_count;
        first_sides[bucket] = side_count;
    });
    std::exclusive_scan(first_edges.begin(), first_edges.end(), first_edges.begin(), 0u);
    std::exclusive_scan(first_sides.begin(), first_sides.end(), first_sides.begin(), 0u);
    table.edges = large_array<EdgeTable::Edge>(first_edges[bucket_count] + 1);
    table.sides = large_array<EdgeTable::Side>(first_sides[bucket_count]);
    buckets.for_each([&](std::size_t bucket, const std::uint32_t* number, std::uint32_t*) {
        std::uint32_t next = first_edges[bucket];
        for (std::uint32_t s = first_sides[bucket]; s < first_sides[bucket + 1]; ++s, ++number) {
            const LooseSide side = side_of(*number);
            const EdgeTable::Edge edge = {{side.vertices[0], side.vertices[1]}, s};
            const bool is_new = s == first_sides[bucket] ||
                                edge.vertices[0] != table.edges[next - 1].vertices[0] ||
                                edge.vertices[1] != table.edges[next - 1].vertices[1];
            if (is_new) table.edges[next++] = edge;
            table.sides[s] = {side.triangle, side.is_reversed};
        }
    });
    table.edges.back() = {{0, 0}, first_sides[bucket_count]};
}

inline void gather_edges(const std::vector<Triangle>& triangles, std::size_t vertices,
                         EdgeTable& table) {
    const auto side_of = [&](std::uint32_t i) {
        const Triangle& t = triangles[i / 3];
        return side_between(t[i % 3], t[(i + 1) % 3], i / 3);
    };
    gather_edges(3 * triangles.size(), side_of, vertices, table);
}

}  // namespace laplacian_lines
