// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>

#include "mesh/prepared_mesh.h"
#include "mesh/vertex_ranges.h"
#include "system/large_array.h"
#include "system/parallel.h"

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

/// Sorts triangles by their smallest vertex, which becomes the first; stable. First by ranges of
/// vertices, block by block, then within each range.
class TriangleSort {
public:
    explicit TriangleSort(PreparedMesh& mesh)
        : triangles_(mesh.triangles),
          blocks_(block_count(triangles_.size())),
          ranges_(mesh.size() / kRange + 1),
          places_(ranges_ * blocks_ + 1, 0) {}

    void run() {
        in_blocks(triangles_.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                Triangle& t = triangles_[i];
                std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
                ++place(t, begin);
            }
        });
        std::exclusive_scan(places_.begin(), places_.end(), places_.begin(), 0u);
        const std::vector<std::uint32_t> starts = starts_of_ranges();
        std::vector<Triangle> by_range = large_array<Triangle>(triangles_.size());
        in_blocks(triangles_.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                by_range[place(triangles_[i], begin)++] = triangles_[i];
        });
        in_parallel(ranges_,
                    [&](std::size_t r) { sort_range(r, by_range, starts[r], starts[r + 1]); });
    }

private:
    static constexpr std::uint32_t kRange = 4096;  // vertices

    std::uint32_t& place(const Triangle& t, std::size_t begin_of_block) {
        return places_[t[0] / kRange * blocks_ + begin_of_block / kBlockElements];
    }

    std::vector<std::uint32_t> starts_of_ranges() const {
        std::vector<std::uint32_t> starts;
        for (std::size_t r = 0; r <= ranges_; ++r)
            starts.push_back(places_[r * blocks_]);
        return starts;
    }

    void sort_range(std::size_t r, const std::vector<Triangle>& by_range, std::uint32_t begin,
                    std::uint32_t end) {
        std::vector<std::uint32_t> next(kRange, 0);
        for (std::uint32_t i = begin; i < end; ++i)
            ++next[by_range[i][0] - r * kRange];
        std::exclusive_scan(next.begin(), next.end(), next.begin(), begin);
        for (std::uint32_t i = begin; i < end; ++i)
            triangles_[next[by_range[i][0] - r * kRange]++] = by_range[i];
    }

    std::vector<Triangle>& triangles_;
    const std::size_t blocks_, ranges_;
    std::vector<std::uint32_t> places_;  // by range, then by block
};

template <class T>
void permute(std::vector<T>& values, const std::vector<std::uint32_t>& order) {
    std::vector<T> permuted = large_array<T>(values.size());
    for_each_element(order.size(), [&](std::size_t i) { permuted[i] = values[order[i]]; });
    values.swap(permuted);
}

}  // namespace

SpatialTree sort_in_space(PreparedMesh& mesh) {
    std::vector<std::uint32_t> order;
    SpatialTree tree(mesh.positions, order);
    std::vector<std::uint32_t> place = large_array<std::uint32_t>(order.size());
    for_each_element(order.size(), [&](std::size_t i) { place[order[i]] = std::uint32_t(i); });
    permute(mesh.positions, order);
    permute(mesh.original_vertex, order);
    for_each_element(mesh.triangles.size(), [&](std::size_t t) {
        for (std::uint32_t& v : mesh.triangles[t])
            v = place[v];
    });
    TriangleSort(mesh).run();
    find_masses(mesh);
    return tree;
}

}  // namespace laplacian_lines
