// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/sight_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "laplacian_lines/error.h"
#include "mesh/bounding_box.h"
#include "mesh/equal_positions.h"
#include "system/disjoint_sets.h"
#include "system/equal_elements.h"
#include "visibility/surface_contacts.h"
#include "visibility/vertex_places.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3d;

// Of the size of the coordinates: four units in the last place of a float, which files hold.
constexpr double kPrecision = 0x1p-22;
// Local. Where coordinates are coarser there is no form left, and all would be at one place.
constexpr double kWorstPrecision = 1e-3;

bool is_finite(const TriangleMesh& mesh, const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) {
        if (v >= mesh.positions.size())
            throw Error(ErrorCode::InvalidMesh, "A triangle names a vertex that is not there.");
        return mesh.positions[v].allFinite();
    });
}

/// The precisions of coordinates as large as these, local.
void find_precisions(const TriangleMesh& mesh, SightMesh& result) {
    double largest = result.size;
    bool are_floats = true;
    for (const Triangle& t : result.triangles)
        for (const std::uint32_t v : t)
            for (const double x : mesh.positions[v]) {
                largest = std::max(largest, std::abs(x));
                are_floats = are_floats && x == double(float(x));
            }
    result.line_precision = std::min(kPrecision * largest / result.size, kWorstPrecision);
    result.precision = are_floats ? result.line_precision : kPrecision;
}

void replace_vertices(const std::vector<std::uint32_t>& by, SightMesh& mesh) {
    for (Triangle& t : mesh.triangles)
        for (std::uint32_t& v : t)
            v = by[v];
}

/// One vertex for all of the same coordinates.
void weld_equal(SightMesh& mesh) {
    replace_vertices(first_equal_positions(mesh.positions), mesh);
}

/// Of borders, one vertex for all at one place; its number is the smallest.
bool weld_borders(SightMesh& mesh) {
    std::vector<bool> on_border(mesh.positions.size());
    for (std::uint32_t e = 0; e < mesh.edge_count(); ++e)
        if (mesh.is_border(e))
            for (const std::uint32_t v : mesh.edges[e].vertices)
                on_border[v] = true;
    if (std::find(on_border.begin(), on_border.end(), true) == on_border.end()) return false;
    const VertexPlaces places(mesh, on_border);
    DisjointSets sets(mesh.positions.size());
    bool any = false;
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
        if (!on_border[v]) continue;
        const Vector3d& p = mesh.positions[v];
        places.visit_along(p, p, mesh.precision, [&](std::uint32_t other) {
            if (other >= v || (mesh.positions[other] - p).norm() > mesh.precision) return;
            sets.unite(v, other);
            any = true;
        });
    }
    if (any) replace_vertices(sets.take_roots(), mesh);
    return any;
}

/// For each end of cuts, the vertices from `first_end` on, the first vertex at its place.
std::vector<std::uint32_t> first_at_ends(const SightMesh& mesh, std::size_t first_end) {
    std::vector<bool> wanted = vertices_of_edges(mesh);
    std::fill(wanted.begin() + std::ptrdiff_t(first_end), wanted.end(), true);
    const VertexPlaces places(mesh, wanted);
    std::vector<std::uint32_t> first;
    for (auto v = std::uint32_t(first_end); v < mesh.positions.size(); ++v) {
        const Vector3d& p = mesh.positions[v];
        std::uint32_t nearest = v;
        places.visit_along(p, p, mesh.precision, [&](std::uint32_t other) {
            if (other < nearest && (mesh.positions[other] - p).norm() <= mesh.precision)
                nearest = other;
        });
        first.push_back(nearest < first_end || nearest == v ? nearest : first[nearest - first_end]);
    }
    return first;
}

/// Ends of cuts that are at the place of another vertex become that one, so that no edge is shorter
/// than the precision.
void weld_ends(std::size_t first_end, const SightMesh& mesh, SurfaceContacts& contacts) {
    if (mesh.positions.size() == first_end) return;
    const std::vector<std::uint32_t> first = first_at_ends(mesh, first_end);
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

/// Adds which of the vertices lie on the ways between `ends_of` each of `count` numbers.
template <class EndsOf>
void find_on_ways(const SightMesh& mesh, std::size_t count, const VertexPlaces& vertices,
                  std::vector<SurfaceContacts::OnEdge>& on_edges, EndsOf ends_of) {
    std::vector<std::vector<SurfaceContacts::OnEdge>> found(block_count(count));
    in_blocks(count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t* const ends = ends_of(i);
            vertices.visit_along(
                mesh.positions[ends[0]], mesh.positions[ends[1]], mesh.precision,
                [&](std::uint32_t v) {
                    if (lies_between(mesh, v, ends[0], ends[1], mesh.precision))
                        found[begin / kBlockElements].push_back({{ends[0], ends[1]}, v});
                });
        }
    });
    for (const auto& of_block : found)
        on_edges.insert(on_edges.end(), of_block.begin(), of_block.end());
}

/// Finds vertices on cuts, and ends of cuts on edges that no triangle of the cut has.
void find_on_cuts(const SightMesh& mesh, SurfaceContacts& contacts) {
    if (contacts.cuts.empty()) return;
    std::vector<bool> are_ends(mesh.positions.size()), are_used = vertices_of_edges(mesh);
    for (const SurfaceContacts::Cut& cut : contacts.cuts)
        for (const std::uint32_t v : cut.vertices)
            are_ends[v] = are_used[v] = true;
    const VertexPlaces used(mesh, are_used), ends(mesh, are_ends);
    find_on_ways(mesh, contacts.cuts.size(), used, contacts.on_edges,
                 [&](std::size_t i) { return contacts.cuts[i].vertices; });
    find_on_ways(mesh, mesh.edge_count(), ends, contacts.on_edges,
                 [&](std::size_t e) { return mesh.edges[e].vertices; });
    std::sort(contacts.on_edges.begin(), contacts.on_edges.end(), come_before);
}

double height_of(const SightMesh& mesh, const Triangle& t) {
    const Vector3d &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    return longest > 0 ? (b - a).cross(c - a).norm() / longest : 0;
}

Triangle sorted(Triangle t) {
    std::sort(t.begin(), t.end());
    return t;
}

/// Takes away triangles that have no height, and all but one of those with the same corners.
void drop_degenerate(SightMesh& mesh) {
    const std::vector<Triangle> all = std::move(mesh.triangles);
    const auto first = first_equals(
        all.size(),
        [&](std::uint32_t i) {
            const Triangle t = sorted(all[i]);
            return mix_hash(mix_hash(t[0], t[1]), t[2]);
        },
        [&](std::uint32_t i, std::uint32_t k) { return sorted(all[i]) == sorted(all[k]); });
    std::vector<std::uint8_t> is_kept(all.size());
    for_each_element(all.size(), [&](std::size_t i) {
        is_kept[i] = first[i] == i && height_of(mesh, all[i]) > mesh.precision;
    });
    mesh.triangles.clear();
    mesh.triangles.reserve(all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
        if (is_kept[i]) mesh.triangles.push_back(all[i]);
}

/// A side between two vertices, before sides are gathered by edges.
struct LooseSide {
    std::uint32_t vertices[2];  // ascending
    std::uint32_t triangle;
    bool is_reversed;
};

bool are_equal(const SightMesh::Side& a, const LooseSide& b) {
    return a.triangle == b.triangle && a.is_reversed == b.is_reversed;
}

/// By edges, in the order of their vertices; those of one edge in the order of the triangles, each
/// once.
void gather_edges(std::vector<LooseSide> loose, SightMesh& mesh) {
    std::vector<std::uint32_t> begins(mesh.positions.size() + 2, 0);
    for (const LooseSide& side : loose)
        ++begins[side.vertices[0] + 2];
    for (std::size_t v = 2; v < begins.size(); ++v)
        begins[v] += begins[v - 1];
    std::vector<LooseSide> sorted(loose.size());
    for (const LooseSide& side : loose)
        sorted[begins[side.vertices[0] + 1]++] = side;
    loose = {};
    for_each_element(mesh.positions.size(), [&](std::size_t v) {
        std::sort(sorted.begin() + begins[v], sorted.begin() + begins[v + 1],
                  [](const LooseSide& a, const LooseSide& b) {
                      return std::tie(a.vertices[1], a.triangle, a.is_reversed) <
                             std::tie(b.vertices[1], b.triangle, b.is_reversed);
                  });
    });
    mesh.edges.clear();
    mesh.sides.clear();
    mesh.sides.reserve(sorted.size());
    for (const LooseSide& side : sorted) {
        const bool is_new = mesh.edges.empty() ||
                            mesh.edges.back().vertices[0] != side.vertices[0] ||
                            mesh.edges.back().vertices[1] != side.vertices[1];
        if (is_new)
            mesh.edges.push_back(
                {{side.vertices[0], side.vertices[1]}, std::uint32_t(mesh.sides.size())});
        if (is_new || !are_equal(mesh.sides.back(), side))
            mesh.sides.push_back({side.triangle, side.is_reversed});
    }
    mesh.edges.push_back({{0, 0}, std::uint32_t(mesh.sides.size())});
}

void add_side(std::uint32_t from, std::uint32_t to, std::uint32_t triangle,
              std::vector<LooseSide>& sides) {
    if (from != to)
        sides.push_back({{std::min(from, to), std::max(from, to)}, triangle, from > to});
}

std::vector<LooseSide> sides_of_triangles(const SightMesh& mesh) {
    std::vector<LooseSide> sides;
    sides.reserve(3 * mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            add_side(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3], t, sides);
    return sides;
}

/// Both triangles of a cut lie on both sides of it.
void add_cuts(const std::vector<SurfaceContacts::Cut>& cuts, SightMesh& mesh) {
    if (cuts.empty()) return;
    std::vector<LooseSide> sides = sides_of_triangles(mesh);
    for (const SurfaceContacts::Cut& cut : cuts)
        for (const std::uint32_t triangle : cut.triangles) {
            add_side(cut.vertices[0], cut.vertices[1], triangle, sides);
            add_side(cut.vertices[1], cut.vertices[0], triangle, sides);
        }
    gather_edges(std::move(sides), mesh);
}

/// The vertices on an edge, from its first to its second.
std::vector<std::uint32_t> way_along(const SightMesh& mesh, const SightMesh::Edge& edge,
                                     const SurfaceContacts::OnEdge* begin,
                                     const SurfaceContacts::OnEdge* end) {
    const Vector3d& from = mesh.positions[edge.vertices[0]];
    std::vector<std::pair<double, std::uint32_t>> on;
    for (; begin != end; ++begin)
        on.emplace_back((mesh.positions[begin->vertex] - from).squaredNorm(), begin->vertex);
    std::sort(on.begin(), on.end());
    on.erase(std::unique(on.begin(), on.end()), on.end());
    std::vector<std::uint32_t> way = {edge.vertices[0]};
    for (const auto& [distance, vertex] : on)
        way.push_back(vertex);
    way.push_back(edge.vertices[1]);
    return way;
}

/// Divides edges at vertices that lie on them.
void divide_edges(const std::vector<SurfaceContacts::OnEdge>& on_edges, SightMesh& mesh) {
    if (on_edges.empty()) return;
    std::vector<LooseSide> sides;
    sides.reserve(mesh.sides.size());
    const SurfaceContacts::OnEdge* next = on_edges.data();
    const SurfaceContacts::OnEdge* const end = next + on_edges.size();
    for (std::uint32_t e = 0; e < mesh.edge_count(); ++e) {
        const SightMesh::Edge& edge = mesh.edges[e];
        const SurfaceContacts::OnEdge* const begin = next;
        while (next != end && next->edge[0] == edge.vertices[0] &&
               next->edge[1] == edge.vertices[1])
            ++next;
        const std::vector<std::uint32_t> way = way_along(mesh, edge, begin, next);
        for (std::size_t s = 0; s < mesh.side_count(e); ++s) {
            const SightMesh::Side side = mesh.sides_of(e)[s];
            for (std::size_t i = 1; i < way.size(); ++i)
                add_side(way[i - (side.is_reversed ? 0 : 1)], way[i - (side.is_reversed ? 1 : 0)],
                         side.triangle, sides);
        }
    }
    gather_edges(std::move(sides), mesh);
}

void find_edges(SightMesh& mesh, const StageProgress& stage) {
    weld_equal(mesh);
    drop_degenerate(mesh);
    gather_edges(sides_of_triangles(mesh), mesh);
    stage.report(0.3);
    if (weld_borders(mesh)) {
        drop_degenerate(mesh);
        gather_edges(sides_of_triangles(mesh), mesh);
    }
    const std::size_t corners = mesh.positions.size();
    SurfaceContacts contacts = find_surface_contacts(mesh, stage.part(0.4, 1));
    weld_ends(corners, mesh, contacts);
    find_on_cuts(mesh, contacts);
    add_cuts(contacts.cuts, mesh);
    divide_edges(contacts.on_edges, mesh);
}

}  // namespace

Vector3d SightMesh::normal(std::uint32_t triangle) const {
    const Triangle& t = triangles[triangle];
    const Vector3d& a = positions[t[0]];
    return (positions[t[1]] - a).cross(positions[t[2]] - a).stableNormalized();
}

SightMesh build_sight_mesh(const TriangleMesh& mesh, const StageProgress& stage) {
    stage.report(0);
    SightMesh result;
    for (const Triangle& t : mesh.triangles)
        if (is_finite(mesh, t)) result.triangles.push_back(t);
    if (result.triangles.empty()) return result;
    const Eigen::AlignedBox3d box =
        bounding_box(3 * result.triangles.size(), [&](std::size_t corner) -> const Vector3d& {
            return mesh.positions[result.triangles[corner / 3][corner % 3]];
        });
    result.centre = box.center();
    if (box.diagonal().norm() > 0) result.size = box.diagonal().norm();
    find_precisions(mesh, result);
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
