// SPDX-License-Identifier: GPL-3.0-or-later
// How the edges of a surface are found, see find_edges():
//  1. Merge equal vertices, also across cracks; collapse sides without length, unfold needles, flip
//     triangles without height, and drop those that are left, and duplicates.
//  2. Close the slits that dropped triangles leave.
//  3. Find where triangles intersect (cuts) or touch (vertices on edges).
//  4. Merge ends of cuts with the vertices that they coincide with; find vertices on cuts; move
//     vertices on edges onto them.
//  5. Divide sides of triangles and cuts at the vertices on them, and group them by edge
//     (edge_building.cpp).
#include "visibility/visibility_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "laplacian_lines/error.h"
#include "mesh/bounding_box.h"
#include "mesh/box_tree.h"
#include "mesh/conforming.h"
#include "mesh/equal_positions.h"
#include "mesh/needles.h"
#include "mesh/triangle_sizes.h"
#include "visibility/surface_contacts.h"
#include "visibility/vertex_lookup.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3d;
using Contact = SurfaceContacts::OnEdge;

// In precisions, of the slits that dropped triangles leave: of two, one on the other. Rims of
// holes, whose vertices may be as near to sides as cracks are wide, keep their form.
constexpr double kWidestSlit = 2;

/// Whether all corners are. @throws Error: InvalidMesh
bool is_finite(const TriangleMesh& mesh, const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) {
        if (v >= mesh.positions.size())
            throw Error(ErrorCode::InvalidMesh, "A triangle names a vertex that is not there.");
        return mesh.positions[v].allFinite();
    });
}

Triangle sorted(Triangle t) {
    std::sort(t.begin(), t.end());
    return t;
}

/// Drops triangles without height, and all but one of those with the same corners.
void drop_triangles(VisibilityMesh& mesh) {
    mesh.triangles = kept(mesh.triangles, [&](std::uint32_t t) {
        return height_of(mesh.positions, mesh.triangles[t]) > mesh.precision;
    });
    const std::vector<std::uint32_t> first = first_equal_triangles(mesh.triangles, sorted);
    mesh.triangles = kept(mesh.triangles, [&](std::uint32_t t) { return first[t] == t; });
}

/// Calls visit(triangle) for all within the precision of a straight line, and others in its box.
template <class Visit>
void visit_triangles(const VisibilityMesh& mesh, const SurfaceContacts& contacts, const Edge& line,
                     Visit visit) {
    contacts.triangles.visit(
        box_around(mesh.positions[line[0]], mesh.positions[line[1]], mesh.precision), visit);
}

/// For each end of a cut, which are the vertices from `first_end` on, the first vertex within the
/// precision.
std::vector<std::uint32_t> first_at_ends(const VisibilityMesh& mesh, std::uint32_t first_end,
                                         const SurfaceContacts& contacts) {
    const VertexLookup ends(mesh, [&](std::uint32_t v) { return v >= first_end; });
    std::vector<std::uint32_t> first(mesh.positions.size() - first_end);
    for_each_element(first.size(), [&](std::size_t i) {
        const auto end = first_end + std::uint32_t(i);
        first[i] = end;
        const auto consider = [&](std::uint32_t v) {
            if (v < first[i] && (mesh.positions[v] - mesh.positions[end]).norm() <= mesh.precision)
                first[i] = v;
        };
        ends.visit_along(mesh.positions[end], mesh.positions[end], mesh.precision, consider);
        visit_triangles(mesh, contacts, {end, end}, [&](std::uint32_t t) {
            for (const std::uint32_t v : mesh.triangles[t])
                consider(v);
        });
    });
    for (std::uint32_t& nearest : first)  // follow ends that are merged themselves
        if (nearest >= first_end) nearest = first[nearest - first_end];
    return first;
}

/// Merges ends of cuts with the vertices that they coincide with, so that no edge is shorter than
/// the precision.
void weld_ends(std::uint32_t first_end, const VisibilityMesh& mesh, SurfaceContacts& contacts) {
    const std::vector<std::uint32_t> first = first_at_ends(mesh, first_end, contacts);
    const auto welded = [&](std::uint32_t v) { return v < first_end ? v : first[v - first_end]; };
    for (SurfaceContacts::Cut& cut : contacts.cuts)
        cut.vertices = edge_between(welded(cut.vertices[0]), welded(cut.vertices[1]));
    contacts.cuts = kept(contacts.cuts, [&](std::uint32_t c) {
        return contacts.cuts[c].vertices[0] != contacts.cuts[c].vertices[1];
    });
    for (Contact& on : contacts.on_edges)
        on.vertex = welded(on.vertex);
    contacts.on_edges = kept(contacts.on_edges, [&](std::uint32_t i) {
        const Contact& on = contacts.on_edges[i];
        return on.vertex != on.edge[0] && on.vertex != on.edge[1];
    });
}

/// Finds vertices on cuts, and ends of cuts on edges that none of the cut's triangles has.
void find_on_cuts(const VisibilityMesh& mesh, SurfaceContacts& contacts) {
    std::vector<bool> are_ends(mesh.positions.size());
    for (const SurfaceContacts::Cut& cut : contacts.cuts)
        for (const std::uint32_t v : cut.vertices)
            are_ends[v] = true;
    const VertexLookup ends(mesh, [&](std::uint32_t v) { return are_ends[v]; });
    const auto add_if_on = [&](std::uint32_t v, const Edge& edge, std::vector<Contact>& found) {
        if (lies_between(mesh.positions, v, edge[0], edge[1], mesh.precision))
            found.push_back({edge, v});
    };
    const auto find_on_cut = [&](std::uint32_t c, std::vector<Contact>& found) {
        const Edge& cut = contacts.cuts[c].vertices;
        ends.visit_along(mesh.positions[cut[0]], mesh.positions[cut[1]], mesh.precision,
                         [&](std::uint32_t v) { add_if_on(v, cut, found); });
        visit_triangles(mesh, contacts, cut, [&](std::uint32_t t) {
            for (const std::uint32_t v : mesh.triangles[t])
                add_if_on(v, cut, found);
        });
    };
    const auto find_at_end = [&](std::uint32_t v, std::vector<Contact>& found) {
        if (!are_ends[v]) return;
        visit_triangles(mesh, contacts, {v, v}, [&](std::uint32_t t) {
            for (std::uint32_t side = 3 * t; side < 3 * t + 3; ++side)
                add_if_on(v, edge_of(mesh.triangles, side), found);
        });
    };
    for (const auto& found : {collect<Contact>(contacts.cuts.size(), find_on_cut),
                              collect<Contact>(mesh.positions.size(), find_at_end)})
        contacts.on_edges.insert(contacts.on_edges.end(), found.begin(), found.end());
}

/// Moves vertices within the precision of an edge onto it: an edge that bends there would leave its
/// triangles' planes, which matters for faces seen edge-on.
void straighten(const std::vector<Contact>& on_edges, VisibilityMesh& mesh) {
    constexpr int kRounds = 3;  // for vertices on several edges
    for (int round = 0; round < kRounds; ++round)
        for (const Contact& on : on_edges) {
            const Vector3d& from = mesh.positions[on.edge[0]];
            const Vector3d span = mesh.positions[on.edge[1]] - from;
            Vector3d& p = mesh.positions[on.vertex];
            p = from + span.dot(p - from) / span.squaredNorm() * span;
        }
}

/// Makes triangles use the same vertices where these, or sides, are as near as cracks are wide.
void merge_places(double crack, VisibilityMesh& mesh) {
    const std::vector<std::uint32_t> place_of =
        make_conforming(mesh.positions, {mesh.precision, crack}, mesh.triangles);
    mesh.triangles = with_places(std::move(mesh.triangles), place_of);
}

/// Makes one vertex of the ends of sides that are not longer than the precision.
void collapse_short_sides(VisibilityMesh& mesh) {
    const auto places = ends_of_short_sides(mesh.positions, mesh.precision, mesh.triangles);
    if (!places.empty()) mesh.triangles = with_places(std::move(mesh.triangles), places);
}

/// The steps above.
void find_edges(VisibilityMesh& mesh, const StageProgress& stage) {
    merge_places(kCrack, mesh);  // 1
    collapse_short_sides(mesh);
    unfold_needles(mesh.positions, mesh.triangles);
    flip_low_triangles(mesh.positions, mesh.precision, mesh.triangles);
    const std::size_t count = mesh.triangles.size();
    drop_triangles(mesh);
    if (mesh.triangles.size() < count) {  // 2
        merge_places(kWidestSlit * mesh.precision, mesh);
        drop_triangles(mesh);
    }
    stage.report(0.3);
    const auto corners = std::uint32_t(mesh.positions.size());
    SurfaceContacts contacts = find_surface_contacts(mesh, stage.part(0.4, 0.9));  // 3
    if (!contacts.cuts.empty()) {                                                  // 4
        weld_ends(corners, mesh, contacts);
        find_on_cuts(mesh, contacts);
    }
    std::sort(contacts.on_edges.begin(), contacts.on_edges.end());
    straighten(contacts.on_edges, mesh);
    build_edges(contacts, mesh);  // 5
    stage.report(1);
}

}  // namespace

std::uint32_t VisibilityMesh::edge_between(std::uint32_t a, std::uint32_t b) const {
    const auto ends = laplacian_lines::edge_between(a, b);
    const auto last = edges.begin() + std::ptrdiff_t(edge_count());
    const auto edge = std::lower_bound(
        edges.begin(), last, ends, [](const Edge& e, const auto& of) { return e.vertices < of; });
    return edge != last && edge->vertices == ends ? std::uint32_t(edge - edges.begin()) : kNoEdge;
}

Vector3d VisibilityMesh::normal(std::uint32_t triangle) const {
    return area_vector(positions, triangles[triangle]).normalized();
}

VisibilityMesh build_visibility_mesh(const TriangleMesh& mesh, const StageProgress& stage) {
    stage.report(0);
    VisibilityMesh result;
    for (const Triangle& t : mesh.triangles)
        if (is_finite(mesh, t)) result.triangles.push_back(t);
    if (result.triangles.empty()) return result;
    const Eigen::AlignedBox3d box = bounding_box(mesh.positions, result.triangles);
    result.centre = box.center();
    if (box.diagonal().norm() > 0) result.size = box.diagonal().norm();
    const Precision precision = precision_of(mesh.positions, box);
    result.precision = precision.of_coordinates / result.size;
    result.line_precision = precision.of_floats / result.size;
    result.positions.resize(mesh.positions.size());
    for_each_element(mesh.positions.size(), [&](std::size_t v) {
        const Vector3d& p = mesh.positions[v];  // unused ones may be anything
        result.positions[v] = box.contains(p) ? result.local(p) : Vector3d::Zero();
    });
    find_edges(result, stage.part(0.1, 1));
    return result;
}

VisibilityMesh build_visibility_mesh(TriangleMesh part, const VisibilityMesh& whole,
                                     const StageProgress& stage) {
    VisibilityMesh result;
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
