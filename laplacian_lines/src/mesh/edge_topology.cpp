// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/edge_topology.h"

#include <algorithm>

namespace laplacian_lines {
namespace {

struct HalfEdge {
    std::uint32_t larger_vertex;
    std::uint32_t corner;  // 3·triangle + k, opposite the edge
};

/// Half-edges sorted by their smaller vertex: those of vertex v are [start[v], start[v+1]).
std::vector<HalfEdge> bucket_by_smaller_vertex(const std::vector<Triangle>& triangles,
                                               std::vector<std::uint32_t>& start) {
    const auto for_each = [&](auto&& visit) {
        for (std::uint32_t i = 0; i < triangles.size(); ++i)
            for (std::uint32_t k = 0; k < 3; ++k) {
                const auto [a, b] =
                    std::minmax(triangles[i][(k + 1) % 3], triangles[i][(k + 2) % 3]);
                visit(a, b, 3 * i + k);
            }
    };
    for_each([&](std::uint32_t a, std::uint32_t, std::uint32_t) { ++start[a + 1]; });
    for (std::size_t v = 1; v < start.size(); ++v)
        start[v] += start[v - 1];
    std::vector<HalfEdge> halves(3 * triangles.size());
    std::vector<std::uint32_t> fill(start.begin(), start.end() - 1);
    for_each([&](std::uint32_t a, std::uint32_t b, std::uint32_t corner) {
        halves[fill[a]++] = {b, corner};
    });
    return halves;
}

}  // namespace

EdgeTopology build_edge_topology(std::size_t vertex_count, const std::vector<Triangle>& triangles) {
    std::vector<std::uint32_t> start(vertex_count + 1, 0);
    std::vector<HalfEdge> halves = bucket_by_smaller_vertex(triangles, start);
    EdgeTopology topology;
    topology.edges_of_triangle.resize(triangles.size());
    for (std::uint32_t v = 0; v < vertex_count; ++v) {
        const auto begin = halves.begin() + start[v], end = halves.begin() + start[v + 1];
        std::sort(begin, end, [](const HalfEdge& x, const HalfEdge& y) {
            return x.larger_vertex != y.larger_vertex ? x.larger_vertex < y.larger_vertex
                                                      : x.corner < y.corner;
        });
        for (auto h = begin; h != end; ++h) {
            if (h == begin || h->larger_vertex != (h - 1)->larger_vertex) ++topology.edge_count;
            topology.edges_of_triangle[h->corner / 3][h->corner % 3] =
                std::uint32_t(topology.edge_count - 1);
        }
    }
    return topology;
}

}  // namespace laplacian_lines
