// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/sight_edges.h"

#include <Eigen/Geometry>
#include <iterator>
#include <tuple>
#include <utility>

namespace laplacian_lines {
namespace {

using Eigen::Vector3d;

double height_of(const SightMesh& mesh, const Triangle& t) {
    const Vector3d &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    return longest > 0 ? (b - a).cross(c - a).norm() / longest : 0;
}

template <class Keep>
void keep_triangles(SightMesh& mesh, Keep keep) {
    std::vector<std::uint8_t> is_kept(mesh.triangles.size());
    for_each_element(is_kept.size(), [&](std::size_t t) { is_kept[t] = keep(std::uint32_t(t)); });
    std::size_t count = 0;
    for (std::size_t t = 0; t < is_kept.size(); ++t)
        if (is_kept[t]) mesh.triangles[count++] = mesh.triangles[t];
    mesh.triangles.resize(count);
}

void gather_edges(const std::vector<LooseSide>& sides, std::size_t vertices, EdgeTable& table) {
    const auto side_of = [&](std::uint32_t i) { return sides[i]; };
    gather_edges(sides.size(), side_of, vertices, table);
}

/// Triangles with the corners of an earlier one.
std::vector<std::uint8_t> find_equal_triangles(const SightMesh& mesh) {
    std::vector<std::uint8_t> are_equal(mesh.triangles.size());
    for_each_element(mesh.edge_count(), [&](std::size_t e) {
        const SightMesh::Edge& edge = mesh.edges[e];
        const std::size_t count = mesh.side_count(std::uint32_t(e));
        const SightMesh::Side* sides = mesh.sides_of(std::uint32_t(e));
        const auto largest = [&](std::size_t i) {
            const Triangle& t = mesh.triangles[sides[i].triangle];
            return std::max({t[0], t[1], t[2]});
        };
        if (count < 2 || (count == 2 && largest(0) != largest(1))) return;
        std::vector<std::pair<std::uint32_t, std::uint32_t>> by_third;  // corner, triangle
        for (std::size_t i = 0; i < count; ++i)
            if (largest(i) > edge.vertices[1]) by_third.emplace_back(largest(i), sides[i].triangle);
        std::sort(by_third.begin(), by_third.end());
        for (std::size_t i = 1; i < by_third.size(); ++i)
            if (by_third[i].first == by_third[i - 1].first) are_equal[by_third[i].second] = 1;
    });
    return are_equal;
}

}  // namespace

void build_edges(SightMesh& mesh) {
    keep_triangles(
        mesh, [&](std::uint32_t t) { return height_of(mesh, mesh.triangles[t]) > mesh.precision; });
    const auto gather = [&] { gather_edges(mesh.triangles, mesh.positions.size(), mesh); };
    gather();
    const std::vector<std::uint8_t> are_equal = find_equal_triangles(mesh);
    if (std::find(are_equal.begin(), are_equal.end(), 1) == are_equal.end()) return;
    keep_triangles(mesh, [&](std::uint32_t t) { return !are_equal[t]; });
    gather();
}

void change_edges(const std::vector<LooseSide>& sides, const std::vector<std::uint32_t>& gone,
                  SightMesh& mesh) {
    EdgeTable added, all;
    gather_edges(sides, mesh.positions.size(), added);
    all.edges.reserve(mesh.edges.size() + added.edges.size());
    all.sides.reserve(mesh.sides.size() + added.sides.size());
    const auto ends = [](const EdgeTable& of, std::uint32_t e) {
        return std::tie(of.edges[e].vertices[0], of.edges[e].vertices[1]);
    };
    const auto append = [&](const EdgeTable& from, std::uint32_t e) {
        const SightMesh::Edge& edge = from.edges[e];
        all.edges.push_back(
            {{edge.vertices[0], edge.vertices[1]}, std::uint32_t(all.sides.size())});
        all.sides.insert(all.sides.end(), from.sides_of(e), from.sides_of(e) + from.side_count(e));
    };
    const auto append_both = [&](std::uint32_t e, std::uint32_t a) {
        all.edges.push_back({{mesh.edges[e].vertices[0], mesh.edges[e].vertices[1]},
                             std::uint32_t(all.sides.size())});
        const auto less = [](const EdgeTable::Side& s, const EdgeTable::Side& t) {
            return s.triangle != t.triangle ? s.triangle < t.triangle
                                            : s.is_reversed < t.is_reversed;
        };
        std::set_union(mesh.sides_of(e), mesh.sides_of(e) + mesh.side_count(e), added.sides_of(a),
                       added.sides_of(a) + added.side_count(a), std::back_inserter(all.sides),
                       less);
    };
    auto next_gone = gone.begin();
    std::uint32_t a = 0;
    for (std::uint32_t e = 0; e < mesh.edge_count(); ++e) {
        if (next_gone != gone.end() && *next_gone == e) {
            ++next_gone;
            continue;
        }
        while (a < added.edge_count() && ends(added, a) < ends(mesh, e))
            append(added, a++);
        if (a < added.edge_count() && ends(added, a) == ends(mesh, e))
            append_both(e, a++);
        else
            append(mesh, e);
    }
    while (a < added.edge_count())
        append(added, a++);
    all.edges.push_back({{0, 0}, std::uint32_t(all.sides.size())});
    mesh.edges = std::move(all.edges);
    mesh.sides = std::move(all.sides);
}

}  // namespace laplacian_lines
