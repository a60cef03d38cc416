// SPDX-License-Identifier: GPL-3.0-or-later
// A needle folded back over its neighbour turns the surface over and back within a rounding error.
// Flipping their common side, the longest of the needle, leaves two triangles that are not folded.
#include "mesh/needles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "mesh/sides_by_edge.h"

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
    const Vector3d u = positions[t[1]] - positions[t[0]], v = positions[t[2]] - positions[t[0]];
    const double square = std::max({u.squaredNorm(), v.squaredNorm(), (v - u).squaredNorm()});
    const double squared_height = u.cross(v).squaredNorm() / square;
    return squared_height < std::min(kNeedle * kNeedle, kSlender * kSlender * square);
}

bool has_three_corners(const Triangle& t) {
    return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
}

std::uint32_t third_of(const Triangle& t, const Edge& edge) {
    return *std::find_if(t.begin(), t.end(),
                         [&](std::uint32_t v) { return v != edge[0] && v != edge[1]; });
}

/// The triangles at the longest side of each needle.
std::map<Edge, std::vector<std::uint32_t>> at_longest_sides(
    const Positions& positions, const std::vector<Triangle>& triangles,
    const std::vector<std::uint32_t>& needles) {
    std::map<Edge, std::vector<std::uint32_t>> at;
    std::vector<bool> is_end(positions.size());  // few vertices are, so look-ups are rare
    for (const std::uint32_t n : needles) {
        const Triangle needle = from_longest(positions, triangles[n]);
        at[edge_between(needle[0], needle[1])];
        is_end[needle[0]] = is_end[needle[1]] = true;
    }
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = triangles[t][k], b = triangles[t][(k + 1) % 3];
            if (!is_end[a] || !is_end[b] || !has_three_corners(triangles[t])) continue;
            const auto edge = at.find(edge_between(a, b));
            if (edge != at.end()) edge->second.push_back(t);
        }
    return at;
}

/// Flips the longest side of a needle that is folded back over its neighbour there, unless that
/// makes another needle. Returns whether it did.
bool unfold(const Positions& positions, Triangle& needle, Triangle& neighbour) {
    const auto [a, b, v] = from_longest(positions, needle);
    const std::uint32_t o = third_of(neighbour, edge_between(a, b));
    Triangle parts[2] = {neighbour, neighbour};  // with its orientation
    std::replace(parts[0].begin(), parts[0].end(), b, v);
    std::replace(parts[1].begin(), parts[1].end(), a, v);
    const Vector3d to_v = across(positions, a, b, v), to_o = across(positions, a, b, o);
    const bool is_folded = o != v && to_v.dot(to_o) > kLeastCosine * to_v.norm() * to_o.norm();
    if (!is_folded || is_needle(positions, parts[0]) || is_needle(positions, parts[1]))
        return false;
    neighbour = parts[0];
    needle = parts[1];
    return true;
}

/// Above the longest side.
double height_of(const Positions& positions, const Triangle& t) {
    const auto [a, b, v] = from_longest(positions, t);
    return a == b ? 0 : across(positions, a, b, v).norm();
}

/// Times twice the area.
Vector3d normal_of(const Positions& positions, const Triangle& t) {
    return (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]);
}

/// The triangles at the edges between some vertices.
class EdgesAt {
public:
    EdgesAt(const std::vector<bool>& is_asked, const std::vector<Triangle>& triangles)
        : is_asked_(is_asked) {
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

    const std::vector<bool>& is_asked_;
    std::map<Edge, std::vector<std::uint32_t>> at_;
};

}  // namespace

void flip_low_triangles(const Positions& positions, double least_height,
                        std::vector<Triangle>& triangles) {
    auto low = collect<std::uint32_t>(triangles.size(), [&](std::uint32_t t, auto& found) {
        if (has_three_corners(triangles[t]) && height_of(positions, triangles[t]) <= least_height)
            found.push_back(t);
    });
    std::vector<bool> is_of_low(positions.size());
    for (const std::uint32_t t : low)
        for (const std::uint32_t v : triangles[t])
            is_of_low[v] = true;
    if (low.empty()) return;
    EdgesAt at(is_of_low, triangles);
    const auto flip = [&](std::uint32_t t) {
        const auto [a, b, v] = from_longest(positions, triangles[t]);
        const std::vector<std::uint32_t> two = at[edge_between(a, b)];
        if (two.size() != 2) return false;
        const std::uint32_t other = two[two[0] == t];
        Triangle parts[2] = {triangles[other], triangles[other]};  // with its orientation
        if (third_of(parts[0], edge_between(a, b)) == v) return false;
        std::replace(parts[0].begin(), parts[0].end(), b, v);
        std::replace(parts[1].begin(), parts[1].end(), a, v);
        const double height = height_of(positions, triangles[t]);
        const Vector3d normal = normal_of(positions, triangles[other]);
        for (const Triangle& part : parts)
            if (height_of(positions, part) <= height || normal_of(positions, part).dot(normal) <= 0)
                return false;
        for (const std::uint32_t i : two)
            at.remove(triangles[i], i);
        triangles[t] = parts[0];
        triangles[other] = parts[1];
        for (const std::uint32_t i : two)
            at.add(triangles[i], i);
        if (height_of(positions, parts[1]) <= least_height) low.push_back(other);
        return true;
    };
    for (std::size_t i = 0; i < low.size(); ++i)  // each flip leaves higher ones, so it ends
        while (height_of(positions, triangles[low[i]]) <= least_height && flip(low[i])) {
        }
}

void unfold_needles(const Positions& positions, std::vector<Triangle>& triangles) {
    const auto needles =
        collect<std::uint32_t>(triangles.size(), [&](std::uint32_t t, auto& found) {
            if (has_three_corners(triangles[t]) && is_needle(positions, triangles[t]))
                found.push_back(t);
        });
    if (needles.empty()) return;
    const auto at = at_longest_sides(positions, triangles, needles);
    std::vector<bool> is_changed(triangles.size());
    for (const std::uint32_t n : needles) {
        if (is_changed[n]) continue;
        const Triangle needle = from_longest(positions, triangles[n]);
        const std::vector<std::uint32_t>& two = at.at(edge_between(needle[0], needle[1]));
        if (two.size() != 2) continue;
        const std::uint32_t other = two[two[0] == n];
        if (!is_changed[other] && unfold(positions, triangles[n], triangles[other]))
            is_changed[other] = is_changed[n] = true;
    }
}

}  // namespace laplacian_lines
