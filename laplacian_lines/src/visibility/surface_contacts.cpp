// SPDX-License-Identifier: GPL-3.0-or-later
// Where triangles meet that are no neighbours:
//  1. A tree of boxes finds the pairs that may.
//  2. PairTest takes the heights of each one's corners over the other's plane. If all are on one
//     side they are apart; a corner in reach of a side touches it; with corners on both sides of
//     each other's planes, the triangles intersect in what their segments along both planes
//     share.
//  3. An edge in a triangle's plane cuts it if the surface goes on at both sides of that plane.
//  4. Ends of cuts become vertices, the same one for both triangles of a side.
#include "visibility/surface_contacts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "mesh/box_tree.h"
#include "mesh/conforming.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3d;

/// Where a triangle's side meets another's plane: between the two vertices of `side`, ascending, or
/// at one if both are equal.
struct CutEnd {
    Edge side;
    std::uint32_t pierced = 0;  // the other triangle; 0 for corners
    Vector3d position = Vector3d::Zero();
};

struct FoundCut {
    CutEnd ends[2];
    std::uint32_t triangles[2];
};

bool has_corner(const Triangle& t, std::uint32_t vertex) {
    return vertex == t[0] || vertex == t[1] || vertex == t[2];
}

/// Signed distances of a triangle's corners from another's plane.
struct Heights {
    double over[3];
    int signs[3];  // 0: within the precision

    Heights(const VisibilityMesh& mesh, const Triangle& corners, const Vector3d& normal,
            const Vector3d& origin) {
        for (std::size_t k = 0; k < 3; ++k) {
            over[k] = normal.dot(mesh.positions[corners[k]] - origin);
            signs[k] = over[k] > mesh.precision ? 1 : over[k] < -mesh.precision ? -1 : 0;
        }
    }

    /// Whether all corners but common ones are on one side.
    bool are_beside(const Triangle& corners, const Triangle& other) const {
        bool are_over = true, are_under = true;
        for (std::size_t k = 0; k < 3; ++k) {
            if (has_corner(other, corners[k])) continue;
            are_over = are_over && signs[k] > 0;
            are_under = are_under && signs[k] < 0;
        }
        return are_over || are_under;
    }
    bool are_on_both_sides() const {
        return std::max({signs[0], signs[1], signs[2]}) > 0 &&
               std::min({signs[0], signs[1], signs[2]}) < 0;
    }
    /// The one corner off the plane; 3 if there is not just one.
    std::size_t single_corner() const {
        if (std::abs(signs[0]) + std::abs(signs[1]) + std::abs(signs[2]) != 1) return 3;
        return signs[0] != 0 ? 0 : signs[1] != 0 ? 1 : 2;
    }
    /// Whether the triangle goes through the plane, or has a side in it.
    bool reach_across() const { return are_on_both_sides() || single_corner() != 3; }
};

/// A possible cut along an edge in the plane of a triangle, from one of the triangles at the edge.
struct CutAlongEdge {
    Edge edge;
    int side;      // side of the plane on which the triangle at the edge lies
    FoundCut cut;  // both triangles are the one that has the edge in its plane
};

struct Found {
    std::vector<FoundCut> cuts;
    std::vector<CutAlongEdge> along_edges;
    std::vector<SurfaceContacts::OnEdge> on_edges;
};

int common_corners(const Triangle& a, const Triangle& b) {
    int count = 0;
    for (const std::uint32_t v : a)
        count += has_corner(b, v);
    return count;
}

class PairTest {
public:
    explicit PairTest(const VisibilityMesh& mesh) : mesh_(mesh), normals_(mesh.triangles.size()) {
        for_each_element(normals_.size(),
                         [&](std::size_t t) { normals_[t] = mesh.normal(std::uint32_t(t)); });
    }

    void test(std::uint32_t t, std::uint32_t other, Found& found) const {
        const Triangle &a = mesh_.triangles[t], &b = mesh_.triangles[other];
        if (common_corners(a, b) > 1) return;
        const Vector3d &n = normals_[t], &m = normals_[other];
        const Heights of_t(mesh_, a, m, mesh_.positions[b[0]]);
        if (of_t.are_beside(a, b)) return;
        const Heights of_other(mesh_, b, n, mesh_.positions[a[0]]);
        if (of_other.are_beside(b, a)) return;
        find_touching(a, of_t, b, found);
        find_touching(b, of_other, a, found);
        FoundCut cut;
        if (!of_t.reach_across() || !of_other.reach_across() ||
            !find_cut(t, of_t, other, of_other, n.cross(m), cut))
            return;
        if (of_t.are_on_both_sides() && of_other.are_on_both_sides())
            found.cuts.push_back(cut);
        else if (of_other.are_on_both_sides())
            add_along_edge(a, of_t, other, cut, found);
        else if (of_t.are_on_both_sides())
            add_along_edge(b, of_other, t, cut, found);
    }

private:
    void find_touching(const Triangle& corners, const Heights& heights, const Triangle& sides,
                       Found& found) const {
        for (std::size_t k = 0; k < 3; ++k) {
            if (heights.signs[k] != 0 || has_corner(sides, corners[k])) continue;
            for (std::size_t s = 0; s < 3; ++s)
                if (lies_between(mesh_.positions, corners[k], sides[s], sides[(s + 1) % 3],
                                 mesh_.precision))
                    found.on_edges.push_back(
                        {edge_between(sides[s], sides[(s + 1) % 3]), corners[k]});
        }
    }

    /// For a triangle with a side in the plane of another one.
    static void add_along_edge(const Triangle& corners, const Heights& heights,
                               std::uint32_t in_plane, FoundCut cut, Found& found) {
        const std::size_t k = heights.single_corner();
        if (k == 3) return;
        cut.triangles[0] = cut.triangles[1] = in_plane;
        found.along_edges.push_back(
            {edge_between(corners[(k + 1) % 3], corners[(k + 2) % 3]), heights.signs[k], cut});
    }

    /// What the triangles' segments along both planes share; false if that is a point or nothing.
    bool find_cut(std::uint32_t t, const Heights& of_t, std::uint32_t other,
                  const Heights& of_other, const Vector3d& direction, FoundCut& cut) const {
        std::array<CutEnd, 2> ends_of_t, ends_of_other;
        if (!find_ends(t, of_t, other, ends_of_t) || !find_ends(other, of_other, t, ends_of_other))
            return false;
        const auto along = [&](const CutEnd& end) { return direction.dot(end.position); };
        for (auto* ends : {&ends_of_t, &ends_of_other})
            if (along((*ends)[0]) > along((*ends)[1])) std::swap((*ends)[0], (*ends)[1]);
        const CutEnd& begin =
            along(ends_of_t[0]) > along(ends_of_other[0]) ? ends_of_t[0] : ends_of_other[0];
        const CutEnd& end =
            along(ends_of_t[1]) < along(ends_of_other[1]) ? ends_of_t[1] : ends_of_other[1];
        cut.ends[0] = begin;
        cut.ends[1] = end;
        cut.triangles[0] = t;
        cut.triangles[1] = other;
        return along(end) > along(begin) &&
               (end.position - begin.position).norm() > mesh_.precision;
    }

    /// Where the sides of a triangle meet a plane; false unless at two points.
    bool find_ends(std::uint32_t t, const Heights& heights, std::uint32_t other,
                   std::array<CutEnd, 2>& ends) const {
        const Triangle& corners = mesh_.triangles[t];
        std::size_t count = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            if (heights.signs[k] == 0)
                ends[count++] = {{corners[k], corners[k]}, 0, mesh_.positions[corners[k]]};
            if (heights.signs[k] * heights.signs[next] < 0)
                ends[count++] =
                    piercing(corners[k], corners[next], heights.over[k], heights.over[next], other);
        }
        return count == 2;
    }

    /// Bit-identical for both triangles of a side.
    CutEnd piercing(std::uint32_t a, std::uint32_t b, double height_a, double height_b,
                    std::uint32_t other) const {
        if (a > b) std::swap(a, b), std::swap(height_a, height_b);
        const double t = height_a / (height_a - height_b);
        return {{a, b}, other, mesh_.positions[a] + t * (mesh_.positions[b] - mesh_.positions[a])};
    }

    const VisibilityMesh& mesh_;
    std::vector<Vector3d> normals_;  // by triangle
};

template <class T>
void append(const std::vector<T>& from, std::vector<T>& to) {
    to.insert(to.end(), from.begin(), from.end());
}

Found find_pairs(const VisibilityMesh& mesh, BoxTree<3>& tree, const StageProgress& stage) {
    const PairTest pair_test(mesh);
    tree = BoxTree<3>::along_curve(mesh.triangles.size(), local_box(), [&](std::uint32_t t) {
        Eigen::AlignedBox3d box;
        for (const std::uint32_t v : mesh.triangles[t])
            box.extend(mesh.positions[v]);
        return box_around(box, mesh.precision / 2);
    });
    const std::vector<std::uint32_t>& order = tree.order();
    const std::vector<BoxTree<3>::Pair> pairs = tree.pairs();
    stage.report(0.3);
    std::vector<Found> found(pairs.size());
    const auto find_in = [&](std::size_t pair, NoScratch&) {
        tree.visit_pairs(pairs[pair], [&](std::size_t i, std::size_t k) {
            pair_test.test(order[i], order[k], found[pair]);
        });
    };
    parallel_for<NoScratch>(found.size(), stage.part(0.3, 1), find_in, 1);
    Found all;
    for (const Found& of_pair : found) {
        append(of_pair.cuts, all.cuts);
        append(of_pair.along_edges, all.along_edges);
        append(of_pair.on_edges, all.on_edges);
    }
    return all;
}

/// A surface with an edge in a triangle's plane intersects it if it has triangles on both sides.
/// Decided for all triangles at an edge together, so that they agree.
void add_cuts_along_edges(Found& found) {
    const auto key = [](const CutAlongEdge& c) {
        return std::tie(c.edge, c.cut.triangles[0], c.side);
    };
    std::sort(found.along_edges.begin(), found.along_edges.end(),
              [&](const CutAlongEdge& a, const CutAlongEdge& b) { return key(a) < key(b); });
    for (std::size_t i = 1; i < found.along_edges.size(); ++i) {
        const CutAlongEdge &below = found.along_edges[i - 1], &above = found.along_edges[i];
        if (below.edge == above.edge && below.cut.triangles[0] == above.cut.triangles[0] &&
            below.side != above.side)
            found.cuts.push_back(above.cut);
    }
}

}  // namespace

SurfaceContacts find_surface_contacts(VisibilityMesh& mesh, const StageProgress& stage) {
    SurfaceContacts contacts;
    Found found = find_pairs(mesh, contacts.triangles, stage);
    mesh.along_curve = contacts.triangles.order();
    add_cuts_along_edges(found);
    contacts.on_edges = std::move(found.on_edges);
    std::map<std::pair<Edge, std::uint32_t>, std::uint32_t> vertices;
    const auto vertex_of = [&](const CutEnd& end) {
        if (end.side[0] == end.side[1]) return end.side[0];
        const auto number = std::uint32_t(mesh.positions.size());
        const auto [place, is_new] = vertices.try_emplace({end.side, end.pierced}, number);
        if (is_new) {
            mesh.positions.push_back(end.position);
            contacts.on_edges.push_back({end.side, number});
        }
        return place->second;
    };
    for (const FoundCut& cut : found.cuts) {
        const std::uint32_t begin = vertex_of(cut.ends[0]), end = vertex_of(cut.ends[1]);
        if (begin != end)
            contacts.cuts.push_back(
                {edge_between(begin, end), {cut.triangles[0], cut.triangles[1]}});
    }
    return contacts;
}

}  // namespace laplacian_lines
