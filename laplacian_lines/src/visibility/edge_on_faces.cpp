// SPDX-License-Identifier: GPL-3.0-or-later
// Faces seen edge-on, from which needs_contour() answers:
//  1. The triangles that the eye sees within twice its turn of edge-on.
//  2. Neighbours among them whose planes are the same are one face, which is a line in the picture.
//  3. The contours of each face: they may cover its near edge, or parts of it.
#include "visibility/edge_on_faces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "system/disjoint_sets.h"
#include "system/parallel.h"

namespace laplacian_lines {

using Eigen::Vector2d;
using Eigen::Vector3d;

EdgeOnFaces::EdgeOnFaces(const Picture& picture) : picture_(picture), mesh_(picture.mesh()) {
    find_triangles();
    if (is_edge_on_.empty()) return;
    const Edges edges = edges_of_triangles();
    join_triangles(edges);
    note_contours(edges);
}

bool EdgeOnFaces::needs_contour(std::uint32_t edge) const {
    const VisibilityMesh::Side* sides = mesh_.sides_of(edge);
    if (mesh_.side_count(edge) != 2 ||
        is_edge_on(sides[0].triangle) == is_edge_on(sides[1].triangle))
        return false;
    const std::uint32_t triangle = sides[is_edge_on(sides[0].triangle) ? 0 : 1].triangle;
    if (!recedes(edge, triangle)) return false;
    const auto contours = contours_.find(face_of(triangle));
    return contours == contours_.end() || !cover(contours->second, edge);
}

void EdgeOnFaces::find_triangles() {
    // What the given eye sees edge-on is within one turn, what one turned the other way does, two.
    const double least = 2 * EyeFrame::turn();
    is_edge_on_.resize(mesh_.triangles.size());
    for_each_element(is_edge_on_.size(), [&](std::size_t t) {
        const Triangle& corners = mesh_.triangles[t];
        const Vector3d to_eye = picture_.frame().towards_eye(mesh_.positions[corners[0]]);
        is_edge_on_[t] = std::abs(mesh_.normal(std::uint32_t(t)).dot(to_eye)) < least;
    });
    triangles_ = numbers_where(is_edge_on_.size(), [&](std::uint32_t t) { return is_edge_on_[t]; });
    if (triangles_.empty()) is_edge_on_.clear();
}

EdgeOnFaces::Edges EdgeOnFaces::edges_of_triangles() const {
    return numbers_where(mesh_.edge_count(), [&](std::uint32_t e) {
        const VisibilityMesh::Side *begin = mesh_.sides_of(e), *end = begin + mesh_.side_count(e);
        return std::any_of(begin, end, [&](const auto& side) { return is_edge_on(side.triangle); });
    });
}

void EdgeOnFaces::join_triangles(const Edges& edges) {
    DisjointSets faces(triangles_.size());
    for (const std::uint32_t e : edges) {
        if (mesh_.side_count(e) != 2) continue;
        const std::uint32_t a = mesh_.sides_of(e)[0].triangle, b = mesh_.sides_of(e)[1].triangle;
        if (is_edge_on(a) && is_edge_on(b) &&
            mesh_.normal(a).cross(mesh_.normal(b)).norm() < EyeFrame::turn())
            faces.unite(number_of(a), number_of(b));
    }
    face_of_ = faces.take_roots();
}

void EdgeOnFaces::note_contours(const Edges& edges) {
    for (const std::uint32_t e : edges) {
        const VisibilityMesh::Side* sides = mesh_.sides_of(e);
        if (!picture_.is_contour(e)) continue;
        for (std::size_t i = 0; i < mesh_.side_count(e); ++i)
            if (is_edge_on(sides[i].triangle)) contours_[face_of(sides[i].triangle)].push_back(e);
    }
}

bool EdgeOnFaces::is_edge_on(std::uint32_t triangle) const {
    return !is_edge_on_.empty() && is_edge_on_[triangle];
}

std::uint32_t EdgeOnFaces::number_of(std::uint32_t triangle) const {
    return std::uint32_t(std::lower_bound(triangles_.begin(), triangles_.end(), triangle) -
                         triangles_.begin());
}

std::uint32_t EdgeOnFaces::face_of(std::uint32_t triangle) const {
    return face_of_[number_of(triangle)];
}

/// Whether a triangle recedes from the eye away from its edge.
bool EdgeOnFaces::recedes(std::uint32_t edge, std::uint32_t triangle) const {
    const auto& ends = mesh_.edges[edge].vertices;
    const Vector3d &a = picture_.vertex(ends[0]), span = picture_.vertex(ends[1]) - a;
    const Vector3d normal = span.cross(Vector3d::UnitZ()).cross(span);  // to the eye, off the edge
    const Triangle& t = mesh_.triangles[triangle];  // two corners are in line with the edge
    const Vector3d sum = picture_.vertex(t[0]) + picture_.vertex(t[1]) + picture_.vertex(t[2]);
    return normal.dot(sum - 3 * a) < 0;
}

/// Whether edges of a face, which is a line in the picture, together cover another of its edges:
/// their parts of it, sorted, leave no gap from its begin to its end.
bool EdgeOnFaces::cover(const Edges& edges, std::uint32_t other) const {
    const auto at = [&](std::uint32_t e, int end) -> Vector2d {
        return picture_.vertex(mesh_.edges[e].vertices[end]).head<2>();
    };
    const Vector2d a = at(other, 0), span = at(other, 1) - a;
    std::vector<std::pair<double, double>> parts;  // of the span, from 0 to its squared length
    for (const std::uint32_t edge : edges)
        parts.push_back(std::minmax({span.dot(at(edge, 0) - a), span.dot(at(edge, 1) - a)}));
    std::sort(parts.begin(), parts.end());
    const double touch = EyeFrame::turn() * span.norm();  // gaps of edges seen end-on
    double covered = 0;
    for (const auto& [low, high] : parts)
        if (low <= covered + touch) covered = std::max(covered, high);
    return covered >= span.squaredNorm() - touch;
}

}  // namespace laplacian_lines
