// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/sight_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

#include "laplacian_lines/error.h"
#include "mesh/bounding_box.h"
#include "mesh/box_tree.h"
#include "mesh/conforming.h"
#include "mesh/equal_positions.h"
#include "mesh/needles.h"
#include "system/disjoint_sets.h"
#include "system/equal_elements.h"
#include "visibility/surface_contacts.h"
#include "visibility/vertex_places.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3d;

bool is_finite(const TriangleMesh& mesh, const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) {
        if (v >= mesh.positions.size())
            throw Error(ErrorCode::InvalidMesh, "A triangle names a vertex that is not there.");
        return mesh.positions[v].allFinite();
    });
}

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

/// Drops triangles without height, and all but one of those with the same corners.
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

/// Adds sides of triangles; `gone` are edges to remove, ascending.
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

void replace_vertices(const std::vector<std::uint32_t>& by, SightMesh& mesh) {
    for (Triangle& t : mesh.triangles)
        for (std::uint32_t& v : t)
            v = by[v];
}

void weld_equal(SightMesh& mesh) {
    replace_vertices(first_equal_positions(mesh.positions), mesh);
}

/// Merges pairs of vertices, with the smallest of their numbers.
bool weld(const std::vector<std::array<std::uint32_t, 2>>& pairs, SightMesh& mesh) {
    if (pairs.empty()) return false;
    DisjointSets sets(mesh.positions.size());
    for (const auto& [a, b] : pairs)
        sets.unite(a, b);
    replace_vertices(sets.take_roots(), mesh);
    return true;
}

/// Merges border vertices at one place.
bool weld_borders(SightMesh& mesh) {
    std::vector<bool> on_border(mesh.positions.size());
    for (std::uint32_t e = 0; e < mesh.edge_count(); ++e)
        if (mesh.is_border(e))
            for (const std::uint32_t v : mesh.edges[e].vertices)
                on_border[v] = true;
    if (std::find(on_border.begin(), on_border.end(), true) == on_border.end()) return false;
    const VertexPlaces places(mesh, on_border);
    std::vector<std::array<std::uint32_t, 2>> pairs;
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
        if (!on_border[v]) continue;
        const Vector3d& p = mesh.positions[v];
        places.visit_along(p, p, mesh.precision, [&](std::uint32_t other) {
            if (other < v && (mesh.positions[other] - p).norm() <= mesh.precision)
                pairs.push_back({v, other});
        });
    }
    return weld(pairs, mesh);
}

/// For each end of cuts, from `first_end` on, the first vertex at its place.
std::vector<std::uint32_t> first_at_ends(const SightMesh& mesh, std::size_t first_end,
                                         const std::vector<std::uint8_t>& near_cuts) {
    const std::size_t count = mesh.positions.size();
    std::vector<bool> are_ends(count);
    std::fill(are_ends.begin() + std::ptrdiff_t(first_end), are_ends.end(), true);
    const VertexPlaces ends(mesh, are_ends);
    using Pair = std::pair<std::uint32_t, std::uint32_t>;  // an end, another vertex at its place
    const auto find = [&](std::uint32_t v, std::vector<Pair>& found) {
        const Vector3d& p = mesh.positions[v];
        if (v < first_end && !near_cuts[v]) return;
        ends.visit_along(p, p, mesh.precision, [&](std::uint32_t end) {
            if (v < end && (mesh.positions[end] - p).norm() <= mesh.precision)
                found.emplace_back(end, v);
        });
    };
    std::vector<std::uint32_t> first(count - first_end);
    std::iota(first.begin(), first.end(), std::uint32_t(first_end));
    for (const auto& [end, v] : collect<Pair>(count, find))
        first[end - first_end] = std::min(first[end - first_end], v);
    for (std::uint32_t& nearest : first)  // what stands for an end before it
        if (nearest >= first_end) nearest = first[nearest - first_end];
    return first;
}

/// Merges ends of cuts with vertices at their places, so that no edge is shorter than the
/// precision.
void weld_ends(std::size_t first_end, const SightMesh& mesh, SurfaceContacts& contacts) {
    if (mesh.positions.size() == first_end) return;
    const std::vector<std::uint32_t> first = first_at_ends(mesh, first_end, contacts.near_cuts);
    const auto weld = [&](std::uint32_t& v) {
        if (v >= first_end) v = first[v - first_end];
    };
    for (SurfaceContacts::Cut& cut : contacts.cuts) {
        weld(cut.vertices[0]);
        weld(cut.vertices[1]);
        if (cut.vertices[0] > cut.vertices[1]) std::swap(cut.vertices[0], cut.vertices[1]);
    }
    const auto is_empty = [](const SurfaceContacts::Cut& cut) {
        return cut.vertices[0] == cut.vertices[1];
    };
    contacts.cuts.erase(std::remove_if(contacts.cuts.begin(), contacts.cuts.end(), is_empty),
                        contacts.cuts.end());
    for (SurfaceContacts::OnEdge& on : contacts.on_edges)
        weld(on.vertex);
    const auto is_end = [](const SurfaceContacts::OnEdge& on) {
        return on.vertex == on.edge[0] || on.vertex == on.edge[1];
    };
    contacts.on_edges.erase(
        std::remove_if(contacts.on_edges.begin(), contacts.on_edges.end(), is_end),
        contacts.on_edges.end());
}

bool come_before(const SurfaceContacts::OnEdge& a, const SurfaceContacts::OnEdge& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.vertex < b.vertex;
}

/// Finds vertices on cuts, and ends of cuts on edges that none of the cut's triangles has.
void find_on_cuts(const SightMesh& mesh, SurfaceContacts& contacts) {
    using OnEdge = SurfaceContacts::OnEdge;
    if (contacts.cuts.empty()) return;
    std::vector<bool> are_ends(mesh.positions.size());
    for (const SurfaceContacts::Cut& cut : contacts.cuts)
        for (const std::uint32_t v : cut.vertices)
            are_ends[v] = true;
    const auto is_near = [&](std::uint32_t v) {
        return are_ends[v] || (v < contacts.near_cuts.size() && contacts.near_cuts[v]);
    };
    const auto cuts =
        BoxTree<3>::along_curve(contacts.cuts.size(), local_box(), [&](std::uint32_t c) {
            const std::uint32_t* const ends = contacts.cuts[c].vertices;
            return box_around(mesh.positions[ends[0]], mesh.positions[ends[1]], mesh.precision);
        });
    const auto add_if_on = [&](std::uint32_t v, const std::uint32_t* ends,
                               std::vector<OnEdge>& found) {
        if (lies_between(mesh.positions, v, ends[0], ends[1], mesh.precision))
            found.push_back({{ends[0], ends[1]}, v});
    };
    const auto find_cuts = [&](std::uint32_t v, std::vector<OnEdge>& found) {
        if (!is_near(v)) return;
        cuts.visit(Eigen::AlignedBox3f(mesh.positions[v].cast<float>().eval()),
                   [&](std::uint32_t c) {
                       add_if_on(v, contacts.cuts[c].vertices, found);
                       return true;
                   });
    };
    const VertexPlaces ends(mesh, are_ends);
    const auto find_ends = [&](std::uint32_t e, std::vector<OnEdge>& found) {
        const std::uint32_t* const edge = mesh.edges[e].vertices;
        if (!is_near(edge[0]) || !is_near(edge[1])) return;
        ends.visit_along(mesh.positions[edge[0]], mesh.positions[edge[1]], mesh.precision,
                         [&](std::uint32_t v) { add_if_on(v, edge, found); });
    };
    for (const auto& found : {collect<OnEdge>(mesh.positions.size(), find_cuts),
                              collect<OnEdge>(mesh.edge_count(), find_ends)})
        contacts.on_edges.insert(contacts.on_edges.end(), found.begin(), found.end());
    std::sort(contacts.on_edges.begin(), contacts.on_edges.end(), come_before);
}

/// Both triangles of a cut lie on both sides of it.
void add_cuts(const std::vector<SurfaceContacts::Cut>& cuts, SightMesh& mesh) {
    if (cuts.empty()) return;
    std::vector<LooseSide> sides;
    for (const SurfaceContacts::Cut& cut : cuts)
        for (const std::uint32_t triangle : cut.triangles)
            for (const int i : {0, 1})
                sides.push_back(side_between(cut.vertices[i], cut.vertices[1 - i], triangle));
    change_edges(sides, {}, mesh);
}

/// Moves vertices onto the edges that they lie on: within the precision, but an edge that bends
/// there would leave its triangles, and faces seen along their planes would be beside it.
void straighten(const std::vector<SurfaceContacts::OnEdge>& on_edges, SightMesh& mesh) {
    constexpr int kRounds = 3;  // for vertices on several edges
    for (int round = 0; round < kRounds; ++round)
        for (const SurfaceContacts::OnEdge& on : on_edges) {
            const Vector3d& from = mesh.positions[on.edge[0]];
            const Vector3d span = mesh.positions[on.edge[1]] - from;
            Vector3d& p = mesh.positions[on.vertex];
            p = from + span.dot(p - from) / span.squaredNorm() * span;
        }
}

/// The vertices on an edge, in its direction.
std::vector<std::uint32_t> path_along(const SightMesh& mesh, const SightMesh::Edge& edge,
                                      const SurfaceContacts::OnEdge* begin,
                                      const SurfaceContacts::OnEdge* end) {
    const Vector3d& from = mesh.positions[edge.vertices[0]];
    std::vector<std::pair<double, std::uint32_t>> on;
    for (; begin != end; ++begin)
        on.emplace_back((mesh.positions[begin->vertex] - from).squaredNorm(), begin->vertex);
    std::sort(on.begin(), on.end());
    on.erase(std::unique(on.begin(), on.end()), on.end());
    std::vector<std::uint32_t> path = {edge.vertices[0]};
    for (const auto& [distance, vertex] : on)
        path.push_back(vertex);
    path.push_back(edge.vertices[1]);
    return path;
}

/// Divides edges at vertices that lie on them.
void divide_edges(const std::vector<SurfaceContacts::OnEdge>& on_edges, SightMesh& mesh) {
    if (on_edges.empty()) return;
    std::vector<LooseSide> sides;
    std::vector<std::uint32_t> gone;
    const SurfaceContacts::OnEdge* next = on_edges.data();
    const SurfaceContacts::OnEdge* const end = next + on_edges.size();
    while (next != end) {
        const SurfaceContacts::OnEdge* const begin = next;
        while (next != end && next->edge == begin->edge)
            ++next;
        const std::uint32_t e = mesh.edge_between(begin->edge[0], begin->edge[1]);
        if (e == SightMesh::kNoEdge) continue;
        gone.push_back(e);
        const std::vector<std::uint32_t> path = path_along(mesh, mesh.edges[e], begin, next);
        for (std::size_t s = 0; s < mesh.side_count(e); ++s) {
            const SightMesh::Side side = mesh.sides_of(e)[s];
            for (std::size_t i = 1; i < path.size(); ++i)
                sides.push_back(side_between(path[i - (side.is_reversed ? 0 : 1)],
                                             path[i - (side.is_reversed ? 1 : 0)], side.triangle));
        }
    }
    change_edges(sides, gone, mesh);
}

void find_bodies(SightMesh& mesh) {
    bool any_touch = false;
    DisjointSets sets(mesh.triangles.size());
    for (std::uint32_t e = 0; e < mesh.edge_count(); ++e) {
        any_touch = any_touch || mesh.side_count(e) > 2;
        if (mesh.side_count(e) == 2)
            sets.unite(mesh.sides_of(e)[0].triangle, mesh.sides_of(e)[1].triangle);
    }
    if (any_touch) mesh.bodies = sets.take_roots();
}

void find_edges(SightMesh& mesh, const StageProgress& stage) {
    weld_equal(mesh);
    unfold_needles(mesh.positions, mesh.triangles);
    build_edges(mesh);
    stage.report(0.3);
    if (weld_borders(mesh)) build_edges(mesh);
    const std::size_t corners = mesh.positions.size();
    SurfaceContacts contacts = find_surface_contacts(mesh, stage.part(0.4, 1));
    while (weld(contacts.at_one_place, mesh)) {
        build_edges(mesh);
        contacts = find_surface_contacts(mesh, stage.part(1, 1));
    }
    weld_ends(corners, mesh, contacts);
    find_on_cuts(mesh, contacts);
    add_cuts(contacts.cuts, mesh);
    straighten(contacts.on_edges, mesh);
    divide_edges(contacts.on_edges, mesh);
    find_bodies(mesh);
}

}  // namespace

std::uint32_t SightMesh::edge_between(std::uint32_t a, std::uint32_t b) const {
    const auto ends = std::minmax(a, b);
    const auto last = edges.begin() + std::ptrdiff_t(edge_count());
    const auto edge =
        std::lower_bound(edges.begin(), last, ends, [](const Edge& e, const auto& of) {
            return std::tie(e.vertices[0], e.vertices[1]) < std::tie(of.first, of.second);
        });
    const bool is_there =
        edge != last && edge->vertices[0] == ends.first && edge->vertices[1] == ends.second;
    return is_there ? std::uint32_t(edge - edges.begin()) : kNoEdge;
}

Vector3d SightMesh::normal(std::uint32_t triangle) const {
    const Triangle& t = triangles[triangle];
    const Vector3d& a = positions[t[0]];
    return (positions[t[1]] - a).cross(positions[t[2]] - a).normalized();
}

SightMesh build_sight_mesh(const TriangleMesh& mesh, const StageProgress& stage) {
    stage.report(0);
    SightMesh result;
    for (const Triangle& t : mesh.triangles)
        if (is_finite(mesh, t)) result.triangles.push_back(t);
    if (result.triangles.empty()) return result;
    const Eigen::AlignedBox3d box = bounding_box(mesh.positions, result.triangles);
    result.centre = box.center();
    if (box.diagonal().norm() > 0) result.size = box.diagonal().norm();
    const Precision precision = precision_of(mesh.positions, result.triangles, result.size);
    result.precision = precision.of_coordinates / result.size;
    result.line_precision = precision.of_floats / result.size;
    result.positions.resize(mesh.positions.size());
    for_each_element(mesh.positions.size(), [&](std::size_t v) {
        const Vector3d& p = mesh.positions[v];  // those that nobody uses may be anything
        result.positions[v] = box.contains(p) ? result.local(p) : Vector3d::Zero();
    });
    find_edges(result, stage.part(0.1, 1));
    return result;
}

SightMesh build_sight_mesh(TriangleMesh part, const SightMesh& whole, const StageProgress& stage) {
    SightMesh result;
    result.centre = whole.centre;
    result.size = whole.size;
    result.precision = whole.precision;
    result.line_precision = whole.line_precision;
    result.positions = std::move(part.positions);
    result.triangles = std::move(part.triangles);
    find_edges(result, stage);
    return result;
}

}  // namespace laplacian_lines
