// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/edge_on_walls.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace laplacian_lines {

using Eigen::Vector2d;
using Eigen::Vector3d;

EdgeOnWalls::EdgeOnWalls(const Picture& picture) : picture_(picture), mesh_(picture.mesh()) {
    find_walls();
    if (is_wall_.empty()) return;
    const std::vector<std::uint32_t> edges = edges_of_walls();
    walls_ = collect<std::uint32_t>(is_wall_.size(), [&](std::uint32_t t, auto& found) {
        if (is_wall(t)) found.push_back(t);
    });
    join_faces(edges);
    note_folds(edges);
}

void EdgeOnWalls::find_walls() {
    // The eye that was asked for is within one turn, that turned the other way within two.
    const double least = 2 * EyeFrame::turn();
    is_wall_.resize(mesh_.triangles.size());
    for_each_element(is_wall_.size(), [&](std::size_t t) {
        const Triangle& corners = mesh_.triangles[t];
        const Vector3d to_eye = picture_.frame().towards_eye(mesh_.positions[corners[0]]);
        is_wall_[t] = std::abs(mesh_.normal(std::uint32_t(t)).dot(to_eye)) < least;
    });
    if (std::find(is_wall_.begin(), is_wall_.end(), 1) == is_wall_.end()) is_wall_.clear();
}

std::vector<std::uint32_t> EdgeOnWalls::edges_of_walls() const {
    return collect<std::uint32_t>(
        mesh_.edge_count(), [&](std::uint32_t e, std::vector<std::uint32_t>& found) {
            const SightMesh::Side *begin = mesh_.sides_of(e), *end = begin + mesh_.side_count(e);
            if (std::any_of(begin, end, [&](const auto& side) { return is_wall(side.triangle); }))
                found.push_back(e);
        });
}

void EdgeOnWalls::join_faces(const std::vector<std::uint32_t>& edges) {
    DisjointSets faces(walls_.size());
    for (const std::uint32_t e : edges) {
        if (mesh_.side_count(e) != 2) continue;
        const std::uint32_t a = mesh_.sides_of(e)[0].triangle, b = mesh_.sides_of(e)[1].triangle;
        if (is_wall(a) && is_wall(b) &&
            mesh_.normal(a).cross(mesh_.normal(b)).norm() < EyeFrame::turn())
            faces.unite(number_of(a), number_of(b));
    }
    face_of_ = faces.take_roots();
}

std::uint32_t EdgeOnWalls::number_of(std::uint32_t wall) const {
    return std::uint32_t(std::lower_bound(walls_.begin(), walls_.end(), wall) - walls_.begin());
}

void EdgeOnWalls::note_folds(const std::vector<std::uint32_t>& edges) {
    for (const std::uint32_t e : edges) {
        const SightMesh::Side* sides = mesh_.sides_of(e);
        if (!picture_.is_fold(e)) continue;
        for (std::size_t i = 0; i < mesh_.side_count(e); ++i)
            if (is_wall(sides[i].triangle)) folds_[face_of(sides[i].triangle)].push_back(e);
    }
}

bool EdgeOnWalls::drop_at(std::uint32_t edge) const {
    const SightMesh::Side* sides = mesh_.sides_of(edge);
    if (mesh_.side_count(edge) != 2 || is_wall(sides[0].triangle) == is_wall(sides[1].triangle))
        return false;
    const std::uint32_t wall = sides[is_wall(sides[0].triangle) ? 0 : 1].triangle;
    if (!recedes(edge, wall)) return false;
    const auto folds = folds_.find(face_of(wall));
    return folds == folds_.end() || !cover(folds->second, edge);
}

/// Whether a triangle recedes from the eye away from its edge.
bool EdgeOnWalls::recedes(std::uint32_t edge, std::uint32_t triangle) const {
    const auto& ends = mesh_.edges[edge].vertices;
    const Vector3d &a = picture_.vertex(ends[0]), span = picture_.vertex(ends[1]) - a;
    const Vector3d normal = span.cross(Vector3d::UnitZ()).cross(span);  // to the eye, off the edge
    const Triangle& t = mesh_.triangles[triangle];
    return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) {
        return v == ends[0] || v == ends[1] || normal.dot(picture_.vertex(v) - a) < 0;
    });
}

/// Whether edges of one face, which is a line in the picture, lie beside another of its edges all
/// along.
bool EdgeOnWalls::cover(const std::vector<std::uint32_t>& edges, std::uint32_t other) const {
    const auto at = [&](std::uint32_t e, int end) -> Vector2d {
        return picture_.vertex(mesh_.edges[e].vertices[end]).head<2>();
    };
    const Vector2d a = at(other, 0), span = at(other, 1) - a;
    std::vector<std::pair<double, double>> parts;  // of the span, from 0 to its squared length
    for (const std::uint32_t edge : edges)
        parts.push_back(std::minmax({span.dot(at(edge, 0) - a), span.dot(at(edge, 1) - a)}));
    std::sort(parts.begin(), parts.end());
    const double touch = EyeFrame::turn() * span.norm();  // what is so short may be seen end-on
    double covered = 0;
    for (const auto& [low, high] : parts)
        if (low <= covered + touch) covered = std::max(covered, high);
    return covered >= span.squaredNorm() - touch;
}

}  // namespace laplacian_lines
