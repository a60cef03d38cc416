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
/// The sides of the same triangle after and before it.
inline std::uint32_t next_side(std::uint32_t side) {
    return side % 3 == 2 ? side - 2 : side + 1;
}
inline std::uint32_t last_side(std::uint32_t side) {
    return side % 3 == 0 ? side + 2 : side - 1;
}

/// Gathers the sides 0 <= i < count that lie on the same edge_of(i), between `vertices`: calls
/// visit(begin, end, found) with the sides of each edge, ascending. Threads share the edges by
/// their first vertices; each part visits its edges in ascending order and fills one element of the
/// result, whose elements are in the order of the edges.
template <class Found, class EdgeOf, class Visit>
std::vector<Found> visit_edges(std::size_t count, std::size_t vertices, EdgeOf edge_of,
                               Visit visit) {
    struct Side {
        std::uint32_t larger, number;  // vertex of the edge
        bool operator<(const Side& other) const {
            return larger != other.larger ? larger < other.larger : number < other.number;
        }
    };
    constexpr std::size_t kBucket = 1024;
    const std::size_t bucket_count = count / kBucket + 1;
    const auto first_of = [&](std::size_t bucket) {
        return (bucket * vertices + bucket_count - 1) / bucket_count;
    };
    std::vector<Found> found(bucket_count);
    sort_in_buckets(count, bucket_count, [&](std::uint32_t i) {
        return edge_of(i)[0] * bucket_count / vertices;
    }).for_each([&](std::size_t bucket, std::uint32_t* begin, std::uint32_t* end) {
        // first by the edges' smaller vertices, each of which has few edges
        const std::size_t first = first_of(bucket), own = first_of(bucket + 1) - first;
        std::vector<std::uint32_t> ends(own + 2);
        for (const std::uint32_t* i = begin; i != end; ++i)
            ++ends[edge_of(*i)[0] - first + 2];
        std::partial_sum(ends.begin(), ends.end(), ends.begin());
        std::vector<Side> sides(std::size_t(end - begin));
        for (const std::uint32_t* i = begin; i != end; ++i) {
            const auto [smaller, larger] = edge_of(*i);
            sides[ends[smaller - first + 1]++] = {larger, *i};
        }
        for (std::size_t v = 0; v < own; ++v) {
            std::sort(sides.begin() + ends[v], sides.begin() + ends[v + 1]);
            for (std::uint32_t from = ends[v], to = from; from < ends[v + 1]; from = to) {
                for (; to < ends[v + 1] && sides[to].larger == sides[from].larger; ++to)
                    begin[to] = sides[to].number;
                visit(begin + from, begin + to, found[bucket]);
            }
        }
    });
    return found;
}

}  // namespace laplacian_lines
