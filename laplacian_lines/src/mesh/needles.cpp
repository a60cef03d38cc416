// SPDX-License-Identifier: GPL-3.0-or-later
// A needle folded back over its neighbour turns the surface over and back within a rounding error.
// Flipping their common side, the longest of the needle, leaves two triangles that are not folded.
#include "mesh/needles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "mesh/sides_by_edge.h"
#include "mesh/triangle_sizes.h"
#include "system/disjoint_sets.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3d;
using Positions = std::vector<Vector3d>;

constexpr double kSlender = 0.01;     // height over the longest side
constexpr double kNeedle = 1e-4;      // height, D
constexpr double kLeastCosine = 0.9;  // of the angle between triangles that are folded flat

/// Begins with the ends of the longest side.
Triangle from_longest(const Positions& positions, const Triangle& t) {
    const auto square = [&](std::size_t k) {
        return (positions[t[(k + 1) % 3]] - positions[t[k]]).squaredNorm();
    };
    const std::size_t k = square(0) >= square(1) ? (square(0) >= square(2) ? 0 : 2)
                                                 : (square(1) >= square(2) ? 1 : 2);
    return {t[k], t[(k + 1) % 3], t[(k + 2) % 3]};
}

/// From the line through two points to a third.
Vector3d across(const Positions& positions, std::uint32_t a, std::uint32_t b, std::uint32_t v) {
    const Vector3d along = positions[b] - positions[a], to = positions[v] - positions[a];
    const double square = along.squaredNorm();
    return square > 0 ? Vector3d(to - to.dot(along) / square * along) : to;
}

bool is_needle(const Positions& positions, const Triangle& t) {
    const double height = height_of(positions, t);
    return height < kNeedle && height < kSlender * std::sqrt(longest_squared(positions, t));
}

std::uint32_t third_of(const Triangle& t, const Edge& edge) {
    return *std::find_if(t.begin(), t.end(),
                         [&](std::uint32_t v) { return v != edge[0] && v != edge[1]; });
}

/// The triangles at the edges between some vertices.
class EdgesAt {
public:
    EdgesAt(std::vector<bool> is_asked, const std::vector<Triangle>& triangles)
        : is_asked_(std::move(is_asked)) {
        for (std::uint32_t t = 0; t < triangles.size(); ++t)
            add(triangles[t], t);
    }
    void add(const Triangle& corners, std::uint32_t t) {
        for_each_edge(corners, [&](const Edge& edge) { at_[edge].push_back(t); });
    }
    void remove(const Triangle& corners, std::uint32_t t) {
        for_each_edge(corners, [&](const Edge& edge) {
            std::vector<std::uint32_t>& at = at_[edge];
            at.erase(std::remove(at.begin(), at.end(), t), at.end());
        });
    }
    const std::vector<std::uint32_t>& operator[](const Edge& edge) { return at_[edge]; }

private:
    template <class Visit>
    void for_each_edge(const Triangle& t, Visit visit) const {
        if (!has_three_corners(t)) return;
        for (std::size_t k = 0; k < 3; ++k)
            if (is_asked_[t[k]] && is_asked_[t[(k + 1) % 3]])
                visit(edge_between(t[k], t[(k + 1) % 3]));
    }

    const std::vector<bool> is_asked_;  // few vertices are, so look-ups are rare
    std::map<Edge, std::vector<std::uint32_t>> at_;
};

std::vector<bool> corners_of(const std::vector<std::uint32_t>& some,
                             const std::vector<Triangle>& triangles, std::size_t vertices) {
    std::vector<bool> are_corners(vertices);
    for (const std::uint32_t t : some)
        for (const std::uint32_t v : triangles[t])
            are_corners[v] = true;
    return are_corners;
}

/// What a triangle and its neighbour across its longest side become if that side is flipped, with
/// the orientation of the neighbour; nothing if they have the same corners.
std::optional<std::array<Triangle, 2>> flipped(const Positions& positions, const Triangle& t,
                                               const Triangle& neighbour) {
    const auto [a, b, v] = from_longest(positions, t);
    if (third_of(neighbour, edge_between(a, b)) == v) return {};
    std::array<Triangle, 2> parts = {neighbour, neighbour};
    std::replace(parts[0].begin(), parts[0].end(), b, v);
    std::replace(parts[1].begin(), parts[1].end(), a, v);
    return parts;
}

/// Whether a triangle is folded back over its neighbour across its longest side.
bool is_folded(const Positions& positions, const Triangle& t, const Triangle& neighbour) {
    const auto [a, b, v] = from_longest(positions, t);
    const std::uint32_t o = third_of(neighbour, edge_between(a, b));
    const Vector3d to_v = across(positions, a, b, v), to_o = across(positions, a, b, o);
    return to_v.dot(to_o) > kLeastCosine * to_v.norm() * to_o.norm();
}

/// A triangle's neighbour across its longest side, if it has one neighbour there.
std::optional<std::uint32_t> across_longest(const Positions& positions,
                                            const std::vector<Triangle>& triangles, std::uint32_t t,
                                            EdgesAt& at) {
    const Triangle from = from_longest(positions, triangles[t]);
    const std::vector<std::uint32_t>& two = at[edge_between(from[0], from[1])];
    return two.size() == 2 ? std::optional(two[two[0] == t]) : std::nullopt;
}

}  // namespace

std::vector<std::uint32_t> ends_of_short_sides(const Positions& positions, double most_length,
                                               const std::vector<Triangle>& triangles) {
    const auto edges = collect<Edge>(3 * triangles.size(), [&](std::uint32_t side, auto& found) {
        const Edge edge = edge_of(triangles, side);
        if ((positions[edge[0]] - positions[edge[1]]).squaredNorm() <= most_length * most_length)
            found.push_back(edge);
    });
    if (edges.empty()) return {};
    DisjointSets places(positions.size());
    for (const Edge& edge : edges)
        places.unite(edge[0], edge[1]);
    return places.take_roots();
}

void flip_low_triangles(const Positions& positions, double least_height,
                        std::vector<Triangle>& triangles) {
    const auto is_low = [&](std::uint32_t t) {
        return height_of(positions, triangles[t]) <= least_height;
    };
    auto low = numbers_where(triangles.size(), [&](std::uint32_t t) {
        return has_three_corners(triangles[t]) && is_low(t);
    });
    if (low.empty()) return;
    EdgesAt at(corners_of(low, triangles, positions.size()), triangles);
    const auto flip = [&](std::uint32_t t) {
        const auto other = across_longest(positions, triangles, t, at);
        if (!other) return false;
        const auto parts = flipped(positions, triangles[t], triangles[*other]);
        const auto is_better = [&](const Triangle& part) {
            return height_of(positions, part) > height_of(positions, triangles[t]) &&
                   area_vector(positions, part).dot(area_vector(positions, triangles[*other])) > 0;
        };
        if (!parts || !is_better((*parts)[0]) || !is_better((*parts)[1])) return false;
        for (const std::uint32_t i : {t, *other})
            at.remove(triangles[i], i);
        triangles[t] = (*parts)[0];
        triangles[*other] = (*parts)[1];
        for (const std::uint32_t i : {t, *other})
            at.add(triangles[i], i);
        if (is_low(*other)) low.push_back(*other);
        return true;
    };
    for (std::size_t i = 0; i < low.size(); ++i)  // each flip leaves higher ones, so it ends
        while (is_low(low[i]) && flip(low[i])) {
        }
}

void unfold_needles(const Positions& positions, std::vector<Triangle>& triangles) {
    const auto needles = numbers_where(triangles.size(), [&](std::uint32_t t) {
        return has_three_corners(triangles[t]) && is_needle(positions, triangles[t]);
    });
    if (needles.empty()) return;
    EdgesAt at(corners_of(needles, triangles, positions.size()), triangles);
    std::vector<bool> is_changed(triangles.size());
    for (const std::uint32_t n : needles) {
        if (is_changed[n]) continue;
        const auto other = across_longest(positions, triangles, n, at);
        if (!other || is_changed[*other] || !is_folded(positions, triangles[n], triangles[*other]))
            continue;
        const auto parts = flipped(positions, triangles[n], triangles[*other]);
        if (!parts || is_needle(positions, (*parts)[0]) || is_needle(positions, (*parts)[1]))
            continue;
        triangles[*other] = (*parts)[0];
        triangles[n] = (*parts)[1];
        is_changed[*other] = is_changed[n] = true;
    }
}

}  // namespace laplacian_lines
