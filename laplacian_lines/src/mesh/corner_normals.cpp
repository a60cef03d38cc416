// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/corner_normals.h"

#include <cmath>

#include "system/disjoint_sets.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3d;

// Of .51°: half of what the facets of a cylinder of 350 turn by.
constexpr double kBentCosine = 0.99996;

double angle_between(const Vector3d& a, const Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Joins the corners at both ends of edges that are not sharp.
std::vector<std::uint32_t> groups(const std::vector<Triangle>& triangles, const CornerTable& sides,
                                  const FlatFaces& faces) {
    DisjointSets sets(3 * triangles.size());
    for (std::uint32_t side = 0; side < sides.side_count(); ++side) {
        if (!sides.has_neighbour(side) || sides.across(side) < side) continue;
        const std::uint32_t other = sides.across(side);
        if (faces.normals[side / 3].dot(faces.normals[other / 3]) <= kSharpCosine) continue;
        // if not, though the edge is not sharp, they are folded onto each other
        const bool agree = have_one_orientation(triangles, side, other);
        sets.unite(side, agree ? next_side(other) : other);
        sets.unite(next_side(side), agree ? other : next_side(other));
    }
    return sets.take_roots();
}

}  // namespace

CornerNormals::CornerNormals(const PreparedMesh& mesh, const CornerTable& sides,
                             const FlatFaces& faces)
    : mesh_(mesh),
      group_of_(groups(mesh.triangles, sides, faces)),
      sums_(group_of_.size(), Vector3d::Zero()) {
    for (std::uint32_t corner = 0; corner < sums_.size(); ++corner) {
        const std::uint32_t t = corner / 3;
        const Vector3d &p = mesh.positions[begin_of(mesh.triangles, corner)],
                       &next = mesh.positions[end_of(mesh.triangles, corner)],
                       &last = mesh.positions[begin_of(mesh.triangles, previous_side(corner))];
        sums_[group_of_[corner]] +=
            angle_between(next - p, last - p) * faces.areas[faces.face_of[t]] * faces.normals[t];
    }
    is_bent_.resize(sums_.size());
    for (std::uint32_t corner = 0; corner < sums_.size(); ++corner)
        is_bent_[corner] = normal(corner).dot(faces.normals[corner / 3]) < kBentCosine;
}

std::vector<CornerNormals::AtVertex> CornerNormals::at_vertices() const {
    std::vector<AtVertex> result(mesh_.size());
    std::vector<std::uint32_t> group_count(mesh_.size());
    std::vector<double> largest(mesh_.size());
    for (std::uint32_t corner = 0; corner < group_of_.size(); ++corner) {
        const std::uint32_t v = begin_of(mesh_.triangles, corner), group = group_of_[corner];
        if (group == corner) ++group_count[v];
        if (is_bent_[corner] && sums_[group].norm() > largest[v]) {
            largest[v] = sums_[group].norm();
            result[v].normal = normal(corner);
        }
    }
    for (std::uint32_t corner = 0; corner < group_of_.size(); ++corner) {
        const std::uint32_t v = begin_of(mesh_.triangles, corner);
        result[v].is_sharp = group_count[v] > 1;
        if (!result[v].is_sharp) result[v].normal = normal(corner);
    }
    return result;
}

}  // namespace laplacian_lines
