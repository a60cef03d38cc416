// SPDX-License-Identifier: GPL-3.0-or-later
// The order in memory, and what is summed in it:
//  1. Vertices follow the tree.
//  2. Triangles follow their smallest vertex.
//  3. Each vertex gets its mass, a third of the area of the triangles around it.
#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "mesh/conforming.h"
#include "mesh/prepared_mesh.h"
#include "mesh/vertex_ranges.h"
#include "system/buckets.h"

namespace laplacian_lines {
namespace {

void find_masses(PreparedMesh& mesh) {
    mesh.masses = large_array(mesh.size(), 0.);
    const Progress silent;
    VertexRanges(mesh).for_each(
        StageProgress(silent, 0, 1, ""), [&](const VertexRanges::Range& range) {
            range.prefetch(mesh.positions);
            range.for_each_triangle([&](const Triangle& t) {
                const double third_of_area = area_vector(mesh, t).norm() / 6;
                for (std::uint32_t v : t)
                    if (range.holds(v)) mesh.masses[v] += third_of_area;
            });
        });
}

template <class T>
void permute(std::vector<T>& values, const std::vector<std::uint32_t>& order) {
    std::vector<T> permuted = large_array<T>(values.size());
    for_each_element(order.size(), [&](std::size_t i) { permuted[i] = values[order[i]]; });
    values.swap(permuted);
}

/// Sorts triangles by their smallest vertex, which becomes the first; stable.
void sort_triangles(PreparedMesh& mesh) {
    constexpr std::uint32_t kRange = 4096;  // vertices
    std::vector<Triangle>& triangles = mesh.triangles;
    for_each_element(triangles.size(), [&](std::size_t i) {
        Triangle& t = triangles[i];
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    });
    Buckets ranges = sort_in_buckets(triangles.size(), mesh.size() / kRange + 1,
                                     [&](std::uint32_t i) { return triangles[i][0] / kRange; });
    ranges.for_each([&](std::size_t, std::uint32_t* begin, std::uint32_t* end) {
        const std::vector<std::uint32_t> unsorted(begin, end);
        std::array<std::uint32_t, kRange + 1> ends{};  // in the range, by vertex
        for (const std::uint32_t t : unsorted)
            ++ends[triangles[t][0] % kRange + 1];
        std::partial_sum(ends.begin(), ends.end(), ends.begin());
        for (const std::uint32_t t : unsorted)
            begin[ends[triangles[t][0] % kRange]++] = t;
    });
    permute(triangles, ranges.numbers);
}

}  // namespace

SpatialTree sort_in_space(PreparedMesh& mesh) {
    mesh.sides.reset();
    std::vector<std::uint32_t> order;
    SpatialTree tree(mesh.positions, order);
    std::vector<std::uint32_t> place = large_array<std::uint32_t>(order.size());
    for_each_element(order.size(), [&](std::size_t i) { place[order[i]] = std::uint32_t(i); });
    permute(mesh.positions, order);
    permute(mesh.original_vertex, order);
    mesh.triangles = with_places(std::move(mesh.triangles), place);
    sort_triangles(mesh);
    find_masses(mesh);
    return tree;
}

}  // namespace laplacian_lines
