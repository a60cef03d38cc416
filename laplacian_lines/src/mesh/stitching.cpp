// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/stitching.h"

#include <Eigen/Geometry>
#include <utility>

#include "mesh/sides_by_edge.h"
#include "system/disjoint_sets.h"

namespace laplacian_lines {
namespace {

struct Side {
    std::uint32_t from, to;
    std::uint32_t third;  // corner of the triangle
};

/// Sides on which no other triangle lies.
std::vector<Side> find_borders(const std::vector<Triangle>& triangles, std::size_t vertices) {
    std::vector<Side> borders;
    for (const auto& part : visit_edges<std::vector<Side>>(
             3 * triangles.size(), vertices,
             [&](std::uint32_t side) { return edge_of(triangles, side); },
             [&](const std::uint32_t*begin, const std::uint32_t*end, auto&found) {
                 if (end - begin > 1) return;
                 const Triangle& t = triangles[*begin / 3];
                 const unsigned k = *begin % 3;
                 found.push_back({t[k], t[(k + 1) % 3], t[(k + 2) % 3]});
             }))
        borders.insert(borders.end(), part.begin(), part.end());
    return borders;
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
                                       const std::vector<std::uint32_t>& place_of,
                                       const std::vector<Triangle>& triangles) {
    const std::vector<Side> borders = find_borders(triangles, positions.size());
    const auto places_of = [&](std::uint32_t i) {
        return edge_between(place_of[borders[i].from], place_of[borders[i].to]);
    };
    DisjointSets sets(positions.size());
    bool any = false;
    using Pair = std::pair<Side, Side>;
    for (const auto& pairs : visit_edges<std::vector<Pair>>(
             borders.size(), positions.size(), places_of,
             [&](const std::uint32_t*begin, const std::uint32_t*end, auto&found) {
                 if (end - begin == 2) found.emplace_back(borders[begin[0]], borders[begin[1]]);
             }))
        for (auto [a, b] : pairs) {
            if (place_of[a.from] == place_of[b.to])
                std::swap(b.from, b.to);
            else if (are_on_each_other(a, b, positions))
                continue;
            sets.unite(a.from, b.from);
            sets.unite(a.to, b.to);
            any = true;
        }
    return any ? sets.take_roots() : std::vector<std::uint32_t>();
}

}  // namespace laplacian_lines
