// SPDX-License-Identifier: GPL-3.0-or-later
// Cracks: borders that run side by side, and T-junctions, where a vertex on the border of a
// neighbouring triangle leaves the surface open.
//  1. Vertices of borders that are nearly at one place count as one.
//  2. Vertices on border sides are found, nearly or within rounding.
//  3. Sides that they cut are kept if a part of one is an edge of another triangle, so that the cut
//     joins them; surfaces that only touch stay apart.
//  4. Triangles are split at the cuts.
// stitch_cuts() finds vertices to weld: those at one place, at an edge whose two triangles have
// other numbers there.
#include "mesh/conforming.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "mesh/bounding_box.h"
#include "mesh/box_tree.h"
#include "mesh/equal_positions.h"
#include "system/disjoint_sets.h"
#include "system/equal_elements.h"
#include "system/large_array.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3d;

// Relative to the coordinates: two to four units in the last place of a float.
constexpr double kPrecision = 0x1p-22;
// Of the diagonal, at most: small meshes far from the origin would become one vertex.
constexpr double kWorstPrecision = 1e-3;
constexpr double kCrackOfSide = 0.25;  // of the shortest at a vertex, so that none collapses

/// Cuts of sides: the vertices on each, from its first end to its second.
using Cuts = std::map<Edge, std::vector<std::uint32_t>>;

/// The ends of sides, ascending.
std::vector<std::uint32_t> ends_of(const std::vector<Edge>& sides) {
    std::vector<std::uint32_t> ends;
    for (const Edge& side : sides)
        ends.insert(ends.end(), side.begin(), side.end());
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    return ends;
}

/// Borders of a surface, between places.
struct Borders {
    const std::vector<Vector3d>& positions;
    std::vector<Edge> sides;
    Eigen::AlignedBox3d box;
    std::vector<float> cracks;  ///< by vertex: distance within which others count as at its place

    Borders(const std::vector<Vector3d>& all, const Nearness& near,
            const std::vector<Triangle>& triangles)
        : positions(all), sides(border_edges(triangles, all.size())) {
        if (sides.empty()) return;
        box = bounding_box(positions, triangles);
        cracks.assign(positions.size(), float(std::max(near.precision, near.crack)));
        for (const Triangle& t : triangles)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t a = t[k], b = t[(k + 1) % 3];
                const double length = (positions[b] - positions[a]).norm();
                const auto most = float(std::max(near.precision, kCrackOfSide * length));
                cracks[a] = std::min(cracks[a], most);
                cracks[b] = std::min(cracks[b], most);
            }
    }

    double size() const { return box.diagonal().norm(); }
    /// In local coordinates, for box trees.
    Vector3d local(std::uint32_t v) const { return (positions[v] - box.center()) / size(); }
    Eigen::AlignedBox3f place(std::uint32_t v) const {
        return Eigen::AlignedBox3f(local(v).cast<float>().eval());
    }
};

/// Joins each place of a border to the nearest one before it, of those that are nearly there and
/// were not joined themselves: places do not run on from one to the next. Returns whether there
/// were any.
bool join_places(const Borders& borders, std::vector<std::uint32_t>& place_of) {
    const std::vector<std::uint32_t> ends = ends_of(borders.sides);
    const auto tree = BoxTree<3>::along_curve(ends.size(), local_box(), [&](std::uint32_t i) {
        const Vector3d at = borders.local(ends[i]);
        return box_around(at, at, double(borders.cracks[ends[i]]) / borders.size());
    });
    using Pair = std::tuple<std::uint32_t, double, std::uint32_t>;  // sorted, the nearest is first
    const auto find = [&](std::uint32_t i, std::vector<Pair>& found) {
        const std::uint32_t v = ends[i];
        tree.visit(borders.place(v), [&](std::uint32_t k) {
            const std::uint32_t other = ends[k];
            const double distance = (borders.positions[v] - borders.positions[other]).norm();
            if (other < v && distance <= double(std::min(borders.cracks[v], borders.cracks[other])))
                found.emplace_back(v, distance, other);
        });
    };
    auto pairs = collect<Pair>(ends.size(), find);
    if (pairs.empty()) return false;
    std::sort(pairs.begin(), pairs.end());
    std::vector<std::uint32_t> first = numbers_up_to(place_of.size());
    for (const auto& [v, distance, other] : pairs)
        if (first[v] == v && first[other] == other) first[v] = other;
    for (std::uint32_t& place : place_of)
        place = first[place];
    return true;
}

Cuts find_cuts(const Borders& borders) {
    const std::vector<Vector3d>& positions = borders.positions;
    const std::vector<Edge>& sides = borders.sides;
    const auto crack_at = [&](const Edge& side) {
        return double(std::min(borders.cracks[side[0]], borders.cracks[side[1]]));
    };
    const auto tree = BoxTree<3>::along_curve(sides.size(), local_box(), [&](std::uint32_t s) {
        return box_around(borders.local(sides[s][0]), borders.local(sides[s][1]),
                          crack_at(sides[s]) / borders.size());
    });
    const std::vector<std::uint32_t> ends = ends_of(sides);
    using Found = std::pair<std::uint32_t, std::uint32_t>;  // side, vertex
    const auto find = [&](std::uint32_t i, std::vector<Found>& found) {
        const std::uint32_t v = ends[i];
        tree.visit(borders.place(v), [&](std::uint32_t s) {
            const double crack = std::min(crack_at(sides[s]), double(borders.cracks[v]));
            if (lies_between(positions, v, sides[s][0], sides[s][1], crack))
                found.emplace_back(s, v);
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
        visit(edge_between(from, v));
        from = v;
    }
    visit(edge_between(from, cut.first[1]));
}

/// Removes the cuts of which no part is an edge of another triangle: surfaces that only touch stay.
void keep_joining_cuts(const std::vector<Edge>& sides, Cuts& cuts) {
    std::map<Edge, int> counts;
    for (const auto& cut : cuts)
        for_each_part(cut, [&](const Edge& part) { ++counts[part]; });
    for (const Edge& side : sides)
        if (const auto found = counts.find(side); found != counts.end()) ++found->second;
    for (auto cut = cuts.begin(); cut != cuts.end();) {
        bool joins = false;
        for_each_part(*cut, [&](const Edge& part) { joins = joins || counts[part] > 1; });
        cut = joins ? std::next(cut) : cuts.erase(cut);
    }
}

/// By vertex, the number of its position; by position, the first vertex that a triangle uses.
struct Places {
    Places(const std::vector<std::uint32_t>& place_of, const std::vector<Triangle>& triangles)
        : of_vertex(place_of), first_used(place_of.size(), 0xffffffffu) {
        for (const Triangle& t : triangles)
            for (const std::uint32_t v : t)
                first_used[of_vertex[v]] = std::min(first_used[of_vertex[v]], v);
    }
    const std::vector<std::uint32_t>& of_vertex;
    std::vector<std::uint32_t> first_used;
};

/// Splits a triangle from the corner opposite each cut side. `sides`: bit k is set if side k is one
/// of the mesh's triangle.
void cut_triangle(const Triangle& t, unsigned sides, const Places& places, const Cuts& cuts,
                  std::vector<Triangle>& parts) {
    for (unsigned k = 0; k < 3; ++k) {
        const std::uint32_t from = t[k], to = t[(k + 1) % 3], third = t[(k + 2) % 3];
        const Edge side = edge_between(places.of_vertex[from], places.of_vertex[to]);
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

/// Of the edge of a side, with the sign of its direction.
std::uint64_t signed_hash(const std::vector<Triangle>& triangles, std::uint32_t side) {
    const auto [smaller, larger] = edge_of(triangles, side);
    const std::uint64_t hash = mix_hash(0, std::uint64_t(smaller) << 32 | larger);
    return begin_of(triangles, side) == smaller ? hash : -hash;
}

/// Sides of edges that triangles do not pass as often in one direction as in the other, at borders
/// and between triangles of opposite orientation, and of all other edges with the same smaller
/// vertex in `at_places`, which is `triangles` or with_places() of them: of an edge between two
/// positions, either all sides or none. Ascending.
std::vector<std::uint32_t> sides_at_borders(const std::vector<Triangle>& triangles,
                                            const std::vector<Triangle>& at_places,
                                            std::size_t vertices) {
    std::vector<std::uint64_t> sums = large_array<std::uint64_t>(vertices);
    const auto sum_of = [&](std::uint32_t side) -> std::uint64_t& {
        return sums[edge_of(at_places, side)[0]];
    };
    for_each_element(triangles.size(), [&](std::size_t t) {
        for (auto side = std::uint32_t(3 * t); side < 3 * t + 3; ++side)
            __atomic_fetch_add(&sum_of(side), signed_hash(triangles, side), __ATOMIC_RELAXED);
    });
    return numbers_where(3 * triangles.size(),
                         [&](std::uint32_t side) { return sum_of(side) != 0; });
}

/// The two sides of each edge between positions that has two, on different edges between vertices.
std::vector<std::array<std::uint32_t, 2>> find_seams(const std::vector<Triangle>& triangles,
                                                     const std::vector<Triangle>& at_places,
                                                     std::size_t vertices) {
    using Seams = std::vector<std::array<std::uint32_t, 2>>;
    const std::vector<std::uint32_t> open = sides_at_borders(triangles, at_places, vertices);
    const auto add = [&](const std::uint32_t* begin, const std::uint32_t* end, Seams& found) {
        if (end - begin != 2) return;
        const std::uint32_t a = open[begin[0]], b = open[begin[1]];
        if (edge_of(triangles, a) != edge_of(triangles, b)) found.push_back({a, b});
    };
    return concatenate(visit_edges<Seams>(
        open.size(), vertices, [&](std::uint32_t i) { return edge_of(at_places, open[i]); }, add));
}

/// Whether two triangles with the same direction along an edge lie on each other, instead of being
/// neighbours of opposite orientation.
bool are_on_each_other(const std::vector<Vector3d>& positions,
                       const std::vector<Triangle>& triangles, std::uint32_t a, std::uint32_t b) {
    constexpr double kLeastCosine = 0.999;  // of 2.6°
    const Vector3d along = positions[end_of(triangles, a)] - positions[begin_of(triangles, a)];
    const auto across = [&](std::uint32_t side) {
        const Vector3d to =
            positions[triangles[side / 3][(side + 2) % 3]] - positions[begin_of(triangles, side)];
        return (to - to.dot(along) / along.squaredNorm() * along).stableNormalized();
    };
    return across(a).dot(across(b)) > kLeastCosine;
}

// Share left without copies, from which on these are of bodies that touch, not of a doubled mesh.
constexpr double kLeastSingle = 0.6;

/// If most triangles are there twice, or all on both sides, one of each stays. `place_of`: for each
/// vertex one at its place.
void drop_copies(const std::vector<std::uint32_t>& place_of, std::vector<Triangle>& triangles) {
    const std::vector<Triangle> at_places = with_places(triangles, place_of);
    const bool have_two_sides = are_two_sided(at_places);
    const auto key = [have_two_sides](Triangle t) {
        if (have_two_sides)
            std::sort(t.begin(), t.end());
        else
            std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        return t;
    };
    const std::vector<std::uint32_t> first = first_equal_triangles(at_places, key);
    std::vector<Triangle> rest = kept(triangles, [&](std::uint32_t t) { return first[t] == t; });
    if (double(rest.size()) < kLeastSingle * double(triangles.size())) triangles.swap(rest);
}

}  // namespace

std::vector<Triangle> with_places(std::vector<Triangle> triangles,
                                  const std::vector<std::uint32_t>& by) {
    for_each_element(triangles.size(), [&](std::size_t t) {
        for (std::uint32_t& v : triangles[t])
            v = by[v];
    });
    return triangles;
}

bool lies_between(const std::vector<Vector3d>& positions, std::uint32_t vertex, std::uint32_t from,
                  std::uint32_t to, double within) {
    if (vertex == from || vertex == to) return false;
    const Vector3d span = positions[to] - positions[from],
                   aside = positions[vertex] - positions[from];
    const double product = span.dot(aside), square = span.squaredNorm();
    if (!(product > 0 && product < square)) return false;  // the usual case, without a root
    const double length = std::sqrt(square), along = product / length;
    return along > within && along < length - within &&
           (aside - along / length * span).norm() <= within;
}

Precision precision_of(const std::vector<Vector3d>& positions, const Eigen::AlignedBox3d& box) {
    const double diagonal = box.diagonal().norm();
    const double largest = std::max(diagonal, largest_coordinates(box).maxCoeff());
    const double of_floats = std::min(kPrecision * largest, kWorstPrecision * diagonal);
    const double others = sum_of(positions.size(), [&](std::size_t v) {
        const Vector3d& p = positions[v];  // unused ones may be anything
        return box.contains(p) && p != p.cast<float>().cast<double>() ? 1. : 0.;
    });
    return {of_floats, others == 0 ? of_floats : kPrecision * diagonal};
}

bool is_closed(const std::vector<Triangle>& triangles) {
    return sum_of<std::uint64_t>(3 * triangles.size(), [&](std::size_t side) {
               return signed_hash(triangles, std::uint32_t(side));
           }) == 0;
}

bool are_two_sided(const std::vector<Triangle>& triangles) {
    const auto of_triangle = [&](std::size_t t) {
        const auto [a, b, c] = triangles[t];
        const bool faces_back = (a > b) ^ (a > c) ^ (b > c);
        Triangle sorted = triangles[t];
        std::sort(sorted.begin(), sorted.end());
        const std::uint64_t side = std::uint64_t(sorted[0]) << 32 | sorted[1];
        const std::uint64_t hash = mix_hash(mix_hash(0, side), sorted[2]);
        return faces_back ? -hash : hash;
    };
    return sum_of<std::uint64_t>(triangles.size(), of_triangle) == 0;
}

std::vector<Edge> border_edges(const std::vector<Triangle>& triangles, std::size_t vertices) {
    const std::vector<std::uint32_t> open = sides_at_borders(triangles, triangles, vertices);
    const auto of = [&](std::uint32_t i) { return edge_of(triangles, open[i]); };
    const auto add = [&](const std::uint32_t* begin, const std::uint32_t* end,
                         std::vector<Edge>& found) {
        if (end - begin == 1) found.push_back(of(*begin));
    };
    return concatenate(visit_edges<std::vector<Edge>>(open.size(), vertices, of, add));
}

Nearness nearness_of(const std::vector<Vector3d>& positions,
                     const std::vector<Triangle>& triangles) {
    const Eigen::AlignedBox3d box = bounding_box(positions, triangles);
    return {precision_of(positions, box).of_coordinates, kCrack * box.diagonal().norm()};
}

std::vector<std::uint32_t> make_conforming(const std::vector<Vector3d>& positions,
                                           const Nearness& near, std::vector<Triangle>& triangles) {
    std::vector<std::uint32_t> place_of = first_equal_positions(positions, triangles);
    drop_copies(place_of, triangles);
    std::optional<Borders> borders(std::in_place, positions, near,
                                   with_places(triangles, place_of));
    if (join_places(*borders, place_of))
        borders.emplace(positions, near, with_places(triangles, place_of));
    Cuts cuts = find_cuts(*borders);
    keep_joining_cuts(borders->sides, cuts);
    if (cuts.empty()) return place_of;
    const Places places(place_of, triangles);
    std::vector<Triangle> result;
    result.reserve(triangles.size() + 2 * cuts.size());
    for (const Triangle& t : triangles)
        cut_triangle(t, 7, places, cuts, result);
    triangles = std::move(result);
    return place_of;
}

std::vector<std::uint32_t> stitch_cuts(const std::vector<Vector3d>& positions,
                                       const std::vector<std::uint32_t>& place_of,
                                       const std::vector<Triangle>& triangles) {
    const std::vector<Triangle> at_places = with_places(triangles, place_of);
    if (at_places == triangles) return {};
    DisjointSets sets(positions.size());
    bool any = false;
    for (const auto& [a, b] : find_seams(triangles, at_places, positions.size())) {
        const bool agree = have_one_orientation(at_places, a, b);
        if (!agree && are_on_each_other(positions, triangles, a, b)) continue;
        const std::uint32_t from = begin_of(triangles, b), to = end_of(triangles, b);
        sets.unite(begin_of(triangles, a), agree ? to : from);
        sets.unite(end_of(triangles, a), agree ? from : to);
        any = true;
    }
    return any ? sets.take_roots() : std::vector<std::uint32_t>();
}

}  // namespace laplacian_lines
