// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/sight_edges.h"

#include <Eigen/Geometry>
#include <utility>

#include "system/equal_elements.h"

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

void set_edges(EdgeTable table, SightMesh& mesh) {
    static_cast<EdgeTable&>(mesh) = std::move(table);
}

Triangle sorted(Triangle t) {
    std::sort(t.begin(), t.end());
    return t;
}

/// For each triangle the first one with the same corners.
std::vector<std::uint32_t> first_equal_triangles(const std::vector<Triangle>& triangles) {
    const auto hash_of = [&](std::uint32_t i) {
        const Triangle t = sorted(triangles[i]);
        return mix_hash(mix_hash(mix_hash(0, t[0]), t[1]), t[2]);
    };
    return first_equals(triangles.size(), hash_of, [&](std::uint32_t a, std::uint32_t b) {
        return sorted(triangles[a]) == sorted(triangles[b]);
    });
}

}  // namespace

void build_edges(SightMesh& mesh) {
    keep_triangles(
        mesh, [&](std::uint32_t t) { return height_of(mesh, mesh.triangles[t]) > mesh.precision; });
    const std::vector<std::uint32_t> first = first_equal_triangles(mesh.triangles);
    keep_triangles(mesh, [&](std::uint32_t t) { return first[t] == t; });
    const auto side_of = [&](std::uint32_t i) {
        return side_between(begin_of(mesh.triangles, i), end_of(mesh.triangles, i), i / 3);
    };
    set_edges(gather_edges(3 * mesh.triangles.size(), mesh.positions.size(), side_of), mesh);
}

void change_edges(std::vector<LooseSide> sides, const std::vector<std::uint32_t>& gone,
                  SightMesh& mesh) {
    auto next_gone = gone.begin();
    for (std::uint32_t e = 0; e < mesh.edge_count(); ++e) {
        if (next_gone != gone.end() && *next_gone == e) {
            ++next_gone;
            continue;
        }
        const auto& [from, to] = mesh.edges[e].vertices;
        for (std::size_t i = 0; i < mesh.side_count(e); ++i) {
            const SightMesh::Side side = mesh.sides_of(e)[i];
            sides.push_back({{from, to}, side.triangle, bool(side.is_reversed)});
        }
    }
    const auto side_of = [&](std::uint32_t i) { return sides[i]; };
    set_edges(gather_edges(sides.size(), mesh.positions.size(), side_of), mesh);
}

}  // namespace laplacian_lines
