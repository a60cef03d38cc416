// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/stitching.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "mesh/equal_positions.h"
#include "system/disjoint_sets.h"
#include "system/equal_elements.h"
#include "system/large_array.h"
#include "system/parallel.h"

namespace laplacian_lines {

bool is_closed(const std::vector<Triangle>& triangles) {
    std::vector<std::uint64_t> sums(block_count(triangles.size()));
    in_blocks(triangles.size(), [&](std::size_t begin, std::size_t end) {
        std::uint64_t sum = 0;
        for (std::size_t t = begin; t < end; ++t)
            for (unsigned k = 0; k < 3; ++k) {
                const std::uint64_t u = triangles[t][k], v = triangles[t][(k + 1) % 3];
                const std::uint64_t hash = mix_hash(0, std::min(u, v) << 32 | std::max(u, v));
                sum += u < v ? hash : -hash;
            }
        sums[begin / kBlockElements] = sum;
    });
    return std::accumulate(sums.begin(), sums.end(), std::uint64_t(0)) == 0;
}

namespace {

/// Vertices by their coordinates: a place is the first vertex there.
struct Places {
    std::vector<std::uint32_t> of_vertex;
    std::vector<std::uint8_t> is_shared;  ///< by place: by several vertices
    bool any_shared = false;
};
Places find_places(const std::vector<Eigen::Vector3d>& positions) {
    Places places{first_equal_positions(positions), large_array(positions.size(), std::uint8_t(0))};
    for (std::uint32_t v = 0; v < positions.size(); ++v)
        if (places.of_vertex[v] != v) {
            places.is_shared[places.of_vertex[v]] = 1;
            places.any_shared = true;
        }
    return places;
}

struct Side {
    std::uint32_t from, to;
    std::uint32_t third;  // corner of the triangle

    std::pair<std::uint32_t, std::uint32_t> edge() const { return std::minmax(from, to); }
};

/// Calls visit(begin, end) for each run of elements with equal keys, after a stable sort.
template <class Element, class Key, class Visit>
void for_each_run(std::vector<Element>& elements, const Key& key, const Visit& visit) {
    std::stable_sort(elements.begin(), elements.end(),
                     [&](const Element& a, const Element& b) { return key(a) < key(b); });
    for (auto begin = elements.begin(); begin != elements.end();) {
        const auto end = std::find_if(begin, elements.end(),
                                      [&](const Element& e) { return key(e) != key(*begin); });
        visit(begin, end);
        begin = end;
    }
}

/// Sides on which no other triangle lies, with an end at a place that has several vertices.
std::vector<Side> find_cut_sides(const std::vector<Triangle>& triangles, const Places& places) {
    const auto is_shared = [&](std::uint32_t v) { return places.is_shared[places.of_vertex[v]]; };
    std::vector<Side> sides, cuts;
    for (const Triangle& t : triangles)
        for (unsigned k = 0; k < 3; ++k)
            if (is_shared(t[k]) || is_shared(t[(k + 1) % 3]))
                sides.push_back({t[k], t[(k + 1) % 3], t[(k + 2) % 3]});
    for_each_run(
        sides, [](const Side& side) { return side.edge(); },
        [&](auto begin, auto end) {
            if (end - begin == 1) cuts.push_back(*begin);
        });
    return cuts;
}

/// Of triangles with the same direction along one edge: whether they are sheets that lie on each
/// other rather than neighbours that face opposite ways.
bool are_on_each_other(const Side& a, const Side& b,
                       const std::vector<Eigen::Vector3d>& positions) {
    constexpr double kLeastCosine = 0.999;
    const Eigen::Vector3d along = positions[a.to] - positions[a.from];
    const auto across = [&](const Side& side) {
        const Eigen::Vector3d to = positions[side.third] - positions[side.from];
        return (to - to.dot(along) / along.squaredNorm() * along).stableNormalized();
    };
    return across(a).dot(across(b)) > kLeastCosine;
}

}  // namespace

std::vector<std::uint32_t> stitch_cuts(const std::vector<Eigen::Vector3d>& positions,
                                       const std::vector<Triangle>& triangles) {
    if (is_closed(triangles)) return {};
    const Places places = find_places(positions);
    if (!places.any_shared) return {};
    std::vector<Side> cuts = find_cut_sides(triangles, places);
    const auto at_places = [&](const Side& side) {
        return Side{places.of_vertex[side.from], places.of_vertex[side.to], side.third};
    };
    DisjointSets sets(positions.size());
    bool any = false;
    for_each_run(
        cuts, [&](const Side& side) { return at_places(side).edge(); },
        [&](auto begin, auto end) {
            if (end - begin != 2) return;
            const Side a = begin[0];
            Side b = begin[1];
            if (at_places(a).from == at_places(b).to)
                std::swap(b.from, b.to);
            else if (are_on_each_other(a, b, positions))
                return;
            sets.unite(a.from, b.from);
            sets.unite(a.to, b.to);
            any = true;
        });
    return any ? sets.take_roots() : std::vector<std::uint32_t>();
}

}  // namespace laplacian_lines
