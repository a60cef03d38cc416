// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/picture.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace laplacian_lines {
namespace {

using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double cross(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool is_less(const Vector3d& a, const Vector3d& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() != b.y() ? a.y() < b.y() : a.z() < b.z();
}

}  // namespace

Picture::Picture(const VisibilityMesh& mesh, const EyeFrame& frame, const StageProgress& stage)
    : mesh_(mesh), frame_(frame) {
    stage.report(0);
    places_.resize(mesh.positions.size());
    for_each_element(places_.size(),
                     [&](std::size_t v) { places_[v] = frame.project(mesh.positions[v]); });
    facing_.resize(mesh.triangles.size());
    const auto corner = [&](std::size_t t, std::size_t k) -> const Vector3d& {
        return places_[mesh.triangles[t][k]];
    };
    for_each_element(facing_.size(), [&](std::size_t t) {
        facing_[t] = std::int8_t(turn(corner(t, 0), corner(t, 1), corner(t, 2)));
    });
    stage.report(0.4);
    tree_ = {mesh.along_curve, [&](std::uint32_t t) {
                 const Vector3d &a = corner(t, 0), &b = corner(t, 1), &c = corner(t, 2);
                 return box_outside<3>({a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)});
             }};
    stage.report(1);
}

bool Picture::is_contour(std::uint32_t edge) const {
    const VisibilityMesh::Side* sides = mesh_.sides_of(edge);
    return std::all_of(
        sides, sides + mesh_.side_count(edge),
        [&](const VisibilityMesh::Side& side) { return side_of(side) == side_of(sides[0]); });
}

int Picture::turn(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    return is_less(a, b) ? (cross(a, b, c) >= 0 ? 1 : -1) : (cross(b, a, c) >= 0 ? -1 : 1);
}

bool Picture::covers(std::uint32_t triangle, const Vector3d& place) const {
    const Triangle& t = mesh_.triangles[triangle];
    for (std::size_t k = 0; k < 3; ++k)
        if (turn(places_[t[k]], places_[t[(k + 1) % 3]], place) != facing_[triangle]) return false;
    return true;
}

RayHits Picture::cast_ray(const Vector3d& point, const VisibilityMesh::Side* own,
                          std::size_t own_count, double precision, std::uint32_t& occluder) const {
    const Vector3d at = frame_.project(point), to_eye = frame_.towards_eye(point);
    const auto is_own = [&](std::uint32_t triangle) {
        const auto place = std::lower_bound(
            own, own + own_count, triangle,
            [](const VisibilityMesh::Side& side, std::uint32_t t) { return side.triangle < t; });
        return place != own + own_count && place->triangle == triangle;
    };
    RayHits result;
    // From the nearest known surface behind the point to the eye. Where faces are seen edge-on,
    // thousands of triangles are farther behind.
    const auto column = [&] {
        return box_outside<3>({Vector3d(at.x(), at.y(), behind(at.z(), result.gap)),
                               Vector3d(at.x(), at.y(), kInfinity)});
    };
    Eigen::AlignedBox3f box = column();
    const auto is_before = [&](std::uint32_t triangle) {
        if (is_own(triangle) || !covers(triangle, at)) return true;
        const Vector3d& corner = mesh_.positions[mesh_.triangles[triangle][0]];
        const Vector3d normal = facing_[triangle] * mesh_.normal(triangle);
        const double height = normal.dot(point - corner);  // above it for the eye
        if (height < -precision) {
            occluder = triangle;
            return false;
        }
        const double gap = std::max(height, 0.) / normal.dot(to_eye);
        if (gap < result.gap) {
            result.gap = gap;
            box = column();
        }
        return true;
    };
    const bool has_occluder = occluder < facing_.size();  // not in a mesh without triangles
    result.is_hidden = (has_occluder && !is_before(occluder)) || !tree_.visit(box, is_before);
    if (result.is_hidden) result.gap = 0;
    return result;
}

}  // namespace laplacian_lines
