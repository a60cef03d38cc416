// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "system/disjoint_sets.h"
#include "visibility/surface_contacts.h"

namespace laplacian_lines {
namespace {

/// A side of a triangle, a cut through one, or a part of either, not yet grouped by edge.
struct LooseSide {
    Edge edge;
    VisibilityMesh::Side side;
};

/// Appends the parts of a side or cut between the vertices that lie on it. `on_edges`: sorted.
void divide_side(const VisibilityMesh& mesh, const std::vector<SurfaceContacts::OnEdge>& on_edges,
                 std::uint32_t from, std::uint32_t to, std::uint32_t triangle,
                 std::vector<LooseSide>& parts) {
    const Edge edge = edge_between(from, to);
    const auto add = [&](std::uint32_t a, std::uint32_t b) {
        parts.push_back({edge_between(a, b), {triangle, (a > b) != (from > to)}});
    };
    auto contact =
        std::lower_bound(on_edges.begin(), on_edges.end(), SurfaceContacts::OnEdge{edge, 0});
    std::set<std::pair<double, std::uint32_t>> on;
    for (; contact != on_edges.end() && contact->edge == edge; ++contact)
        on.emplace((mesh.positions[contact->vertex] - mesh.positions[edge[0]]).squaredNorm(),
                   contact->vertex);
    std::uint32_t last = edge[0];
    for (const auto& [distance, vertex] : on) {
        add(last, vertex);
        last = vertex;
    }
    add(last, edge[1]);
}

/// By triangle, then by direction.
std::uint32_t key_of(const VisibilityMesh::Side& side) {
    return std::uint32_t(side.triangle) << 1 | side.is_reversed;
}

/// Sorts sides from the place `first` on, and drops all but one of equal ones.
void sort_sides(std::size_t first, std::vector<VisibilityMesh::Side>& sides) {
    const auto begin = sides.begin() + std::ptrdiff_t(first);
    std::sort(begin, sides.end(),
              [](const auto& a, const auto& b) { return key_of(a) < key_of(b); });
    sides.erase(std::unique(begin, sides.end(),
                            [](const auto& a, const auto& b) { return key_of(a) == key_of(b); }),
                sides.end());
}

/// Sets the mesh's edges in the order of their vertices, each with its sides.
void group_by_edge(const std::vector<LooseSide>& loose, VisibilityMesh& mesh) {
    struct Part {
        std::vector<VisibilityMesh::Edge> edges;
        std::vector<VisibilityMesh::Side> sides;
    };
    const auto add_edge = [&](const std::uint32_t* begin, const std::uint32_t* end, Part& part) {
        const std::size_t first = part.sides.size();
        const Edge& edge = loose[*begin].edge;
        part.edges.push_back({edge, std::uint32_t(first)});
        for (const std::uint32_t* i = begin; i != end; ++i)
            part.sides.push_back(loose[*i].side);
        sort_sides(first, part.sides);
    };
    const auto edge_of = [&](std::uint32_t i) -> const Edge& { return loose[i].edge; };
    for (const Part& part :
         visit_edges<Part>(loose.size(), mesh.positions.size(), edge_of, add_edge)) {
        const auto first = std::uint32_t(mesh.sides.size());
        for (VisibilityMesh::Edge edge : part.edges) {
            edge.first_side += first;
            mesh.edges.push_back(edge);
        }
        mesh.sides.insert(mesh.sides.end(), part.sides.begin(), part.sides.end());
    }
    mesh.edges.push_back({{0, 0}, std::uint32_t(mesh.sides.size())});
}

void find_bodies(VisibilityMesh& mesh) {
    bool any_touch = false;
    DisjointSets sets(mesh.triangles.size());
    for (std::uint32_t e = 0; e < mesh.edge_count(); ++e) {
        any_touch = any_touch || mesh.side_count(e) > 2;
        if (mesh.side_count(e) == 2)
            sets.unite(mesh.sides_of(e)[0].triangle, mesh.sides_of(e)[1].triangle);
    }
    if (any_touch) mesh.bodies = sets.take_roots();
}

}  // namespace

void build_edges(const SurfaceContacts& contacts, VisibilityMesh& mesh) {
    const auto divide = [&](std::uint32_t side, std::vector<LooseSide>& parts) {
        divide_side(mesh, contacts.on_edges, begin_of(mesh.triangles, side),
                    end_of(mesh.triangles, side), side / 3, parts);
    };
    auto sides = collect<LooseSide>(3 * mesh.triangles.size(), divide);
    for (const SurfaceContacts::Cut& cut : contacts.cuts)
        for (const std::uint32_t triangle : cut.triangles)
            for (const int i : {0, 1})
                divide_side(mesh, contacts.on_edges, cut.vertices[i], cut.vertices[1 - i], triangle,
                            sides);
    group_by_edge(sides, mesh);
    find_bodies(mesh);
}

}  // namespace laplacian_lines
