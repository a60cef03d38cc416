// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/conforming.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "mesh/bounding_box.h"
#include "mesh/box_tree.h"
#include "mesh/corner_table.h"
#include "mesh/equal_positions.h"
#include "mesh/stitching.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3d;

// Relative to the coordinates: four units in the last place of a float.
constexpr double kPrecision = 0x1p-22;
// Of the diagonal. With coarser coordinates there is no form left, and all would be at one place.
constexpr double kWorstPrecision = 1e-3;

using Side = std::array<std::uint32_t, 2>;  // places, ascending: first vertices there

Side side_of(std::uint32_t a, std::uint32_t b) {
    return {std::min(a, b), std::max(a, b)};
}

/// The sides of triangles that only one triangle has.
std::vector<Side> find_border_sides(const std::vector<Triangle>& triangles, std::size_t vertices) {
    const CornerTable table(triangles, vertices);
    std::vector<Side> sides;
    for (std::uint32_t side = 0; side < table.side_count(); ++side)
        if (table.across(side) == CornerTable::kBorder)
            sides.push_back(side_of(begin_of(triangles, side), end_of(triangles, side)));
    return sides;
}

/// Cuts of sides: the vertices on each, from its first end to its second.
using Cuts = std::map<Side, std::vector<std::uint32_t>>;

Cuts find_cuts(const std::vector<Vector3d>& positions, const std::vector<Side>& sides,
               const Eigen::AlignedBox3d& box, double precision) {
    const double size = box.diagonal().norm();
    const auto local = [&](std::uint32_t v) -> Eigen::Vector3f {
        return ((positions[v] - box.center()) / size).cast<float>();
    };
    const auto box_of = [&](std::uint32_t s) {
        Eigen::AlignedBox3f around(local(sides[s][0]));
        around.extend(local(sides[s][1]));
        // floats round by less than 1e-7 here
        const Eigen::Vector3f more = Eigen::Vector3f::Constant(float(precision / size) + 1e-7f);
        return Eigen::AlignedBox3f(around.min() - more, around.max() + more);
    };
    const auto order = order_along_curve<3>(
        sides.size(), local_box(),
        [&](std::uint32_t s) -> Eigen::Vector3f { return box_of(s).center(); });
    const BoxTree<3> tree(order, box_of);
    std::vector<std::uint32_t> ends;
    for (const Side& side : sides)
        ends.insert(ends.end(), side.begin(), side.end());
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    using Found = std::pair<std::uint32_t, std::uint32_t>;  // side, vertex
    const auto find = [&](std::uint32_t i, std::vector<Found>& found) {
        tree.visit(Eigen::AlignedBox3f(local(ends[i])), [&](std::uint32_t s) {
            if (lies_between(positions, ends[i], sides[s][0], sides[s][1], precision))
                found.emplace_back(s, ends[i]);
            return true;
        });
    };
    Cuts cuts;
    for (const auto& [s, v] : collect<Found>(ends.size(), find))
        cuts[sides[s]].push_back(v);
    for (auto& [side, on] : cuts)
        std::sort(on.begin(), on.end(), [&, from = side[0]](std::uint32_t a, std::uint32_t b) {
            return (positions[a] - positions[from]).squaredNorm() <
                   (positions[b] - positions[from]).squaredNorm();
        });
    return cuts;
}

/// Calls visit(side) for the parts of a cut side.
template <class Visit>
void for_each_part(const Cuts::value_type& cut, Visit visit) {
    std::uint32_t from = cut.first[0];
    for (const std::uint32_t v : cut.second) {
        visit(side_of(from, v));
        from = v;
    }
    visit(side_of(from, cut.first[1]));
}

/// Surfaces that only touch are not cut.
void keep_joining_cuts(const std::vector<Side>& sides, Cuts& cuts) {
    std::map<Side, int> counts;
    for (const auto& cut : cuts)
        for_each_part(cut, [&](const Side& part) { ++counts[part]; });
    for (const Side& side : sides)
        if (const auto found = counts.find(side); found != counts.end()) ++found->second;
    for (auto cut = cuts.begin(); cut != cuts.end();) {
        bool joins = false;
        for_each_part(*cut, [&](const Side& part) { joins = joins || counts[part] > 1; });
        cut = joins ? std::next(cut) : cuts.erase(cut);
    }
}

/// Where vertices are, and at places the first vertex that a triangle has.
struct Places {
    Places(const std::vector<Vector3d>& positions, const std::vector<Triangle>& triangles)
        : of_vertex(first_equal_positions(positions)), first_used(positions.size(), kNone) {
        for (const Triangle& t : triangles)
            for (const std::uint32_t v : t)
                first_used[of_vertex[v]] = std::min(first_used[of_vertex[v]], v);
    }
    static constexpr std::uint32_t kNone = 0xffffffffu;
    std::vector<std::uint32_t> of_vertex, first_used;
};

/// Cut from the corner opposite of each side that is. `sides`: bit k: of the mesh's triangle.
void cut_triangle(const Triangle& t, unsigned sides, const Places& places, const Cuts& cuts,
                  std::vector<Triangle>& parts) {
    for (unsigned k = 0; k < 3; ++k) {
        const std::uint32_t from = t[k], to = t[(k + 1) % 3], third = t[(k + 2) % 3];
        const Side side = side_of(places.of_vertex[from], places.of_vertex[to]);
        const auto cut = sides >> k & 1 ? cuts.find(side) : cuts.end();
        if (cut == cuts.end()) continue;
        std::vector<std::uint32_t> path = {from};
        for (const std::uint32_t place : cut->second)
            if (place != places.of_vertex[third]) path.push_back(places.first_used[place]);
        if (places.of_vertex[from] != side[0]) std::reverse(path.begin() + 1, path.end());
        path.push_back(to);
        const unsigned next = sides >> (k + 1) % 3 & 1, last = sides >> (k + 2) % 3 & 1;
        for (std::size_t i = 1; i < path.size(); ++i) {
            const unsigned left = (i + 1 == path.size() ? next << 1 : 0) | (i == 1 ? last << 2 : 0);
            cut_triangle({path[i - 1], path[i], third}, left, places, cuts, parts);
        }
        return;
    }
    parts.push_back(t);
}

}  // namespace

bool lies_between(const std::vector<Vector3d>& positions, std::uint32_t vertex, std::uint32_t from,
                  std::uint32_t to, double within) {
    if (vertex == from || vertex == to) return false;
    const Vector3d span = positions[to] - positions[from],
                   aside = positions[vertex] - positions[from];
    const double product = span.dot(aside), square = span.squaredNorm();
    if (!(product > 0 && product < square)) return false;  // most, without a root
    const double length = std::sqrt(square), along = product / length;
    return along > within && along < length - within &&
           (aside - along / length * span).norm() <= within;
}

Precision precision_of(const std::vector<Vector3d>& positions,
                       const std::vector<Triangle>& triangles, double diagonal) {
    double largest = diagonal;
    bool are_floats = true;
    for (const Triangle& t : triangles)
        for (const std::uint32_t v : t)
            for (const double x : positions[v]) {
                largest = std::max(largest, std::abs(x));
                are_floats = are_floats && x == double(float(x));
            }
    const double of_floats = std::min(kPrecision * largest, kWorstPrecision * diagonal);
    return {of_floats, are_floats ? of_floats : kPrecision * diagonal};
}

std::size_t make_conforming(const std::vector<Vector3d>& positions,
                            std::vector<Triangle>& triangles) {
    if (is_closed(triangles)) return 0;
    const Places places(positions, triangles);
    std::vector<Triangle> at_places = triangles;
    for_each_element(at_places.size(), [&](std::size_t t) {
        for (std::uint32_t& v : at_places[t])
            v = places.of_vertex[v];
    });
    if (is_closed(at_places)) return 0;
    const std::vector<Side> sides = find_border_sides(at_places, positions.size());
    const Eigen::AlignedBox3d box = bounding_box(positions, triangles);
    Cuts cuts = find_cuts(positions, sides, box,
                          precision_of(positions, triangles, box.diagonal().norm()).of_coordinates);
    keep_joining_cuts(sides, cuts);
    if (cuts.empty()) return 0;
    std::vector<Triangle> result;
    result.reserve(triangles.size() + 2 * cuts.size());
    std::size_t cut = 0;
    for (const Triangle& t : triangles) {
        const std::size_t before = result.size();
        cut_triangle(t, 7, places, cuts, result);
        cut += result.size() > before + 1;
    }
    triangles = std::move(result);
    return cut;
}

}  // namespace laplacian_lines
