// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/corner_table.h"

#include <algorithm>
#include <numeric>

#include "system/buckets.h"

namespace laplacian_lines {
namespace {

struct SideOfEdge {
    std::uint32_t larger;  // vertex of the edge
    std::uint32_t side;

    bool operator<(const SideOfEdge& other) const {
        return larger != other.larger ? larger < other.larger : side < other.side;
    }
};

/// The sides of one edge.
void link(const SideOfEdge* begin, const SideOfEdge* end, std::vector<std::uint32_t>& across) {
    if (end - begin == 2) {
        across[begin[0].side] = begin[1].side;
        across[begin[1].side] = begin[0].side;
    } else {
        for (const SideOfEdge* s = begin; s != end; ++s)
            across[s->side] = end - begin == 1 ? CornerTable::kBorder : CornerTable::kMany;
    }
}

/// Of one vertex. Returns how many edges these are.
std::size_t link_edges(std::vector<SideOfEdge>::iterator begin,
                       std::vector<SideOfEdge>::iterator end, std::vector<std::uint32_t>& across) {
    std::sort(begin, end);
    std::size_t count = 0;
    for (auto first = begin, next = begin; first != end; first = next, ++count) {
        while (next != end && next->larger == first->larger)
            ++next;
        link(&*first, &*first + (next - first), across);
    }
    return count;
}

}  // namespace

CornerTable::CornerTable(const std::vector<Triangle>& triangles, std::size_t vertices)
    : across_(large_array<std::uint32_t>(3 * triangles.size())) {
    constexpr std::size_t kBucket = 1024;
    const std::size_t sides = across_.size(), bucket_count = sides / kBucket + 1;
    const auto smaller = [&](std::uint32_t side) {
        return std::min(begin_of(triangles, side), end_of(triangles, side));
    };
    const auto larger = [&](std::uint32_t side) {
        return std::max(begin_of(triangles, side), end_of(triangles, side));
    };
    std::vector<std::size_t> edges(bucket_count);
    sort_in_buckets(sides, bucket_count, [&](std::uint32_t side) {
        return smaller(side) * bucket_count / vertices;
    }).for_each([&](std::size_t bucket, const std::uint32_t* begin, const std::uint32_t* end) {
        const std::size_t first = (bucket * vertices + bucket_count - 1) / bucket_count,
                          last = ((bucket + 1) * vertices + bucket_count - 1) / bucket_count;
        std::vector<std::uint32_t> ends(last - first + 2);  // by vertex
        for (const std::uint32_t* side = begin; side != end; ++side)
            ++ends[smaller(*side) - first + 2];
        std::partial_sum(ends.begin(), ends.end(), ends.begin());
        std::vector<SideOfEdge> by_vertex(std::size_t(end - begin));
        for (const std::uint32_t* side = begin; side != end; ++side)
            by_vertex[ends[smaller(*side) - first + 1]++] = {larger(*side), *side};
        for (std::size_t v = 0; v < last - first; ++v)
            edges[bucket] +=
                link_edges(by_vertex.begin() + ends[v], by_vertex.begin() + ends[v + 1], across_);
    });
    edge_count_ = std::accumulate(edges.begin(), edges.end(), std::size_t(0));
}

}  // namespace laplacian_lines
