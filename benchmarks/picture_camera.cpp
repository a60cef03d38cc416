// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture_camera.h"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

namespace benchmarks {

using laplacian_lines::Triangle;
using laplacian_lines::TriangleMesh;
using laplacian_lines::View;

namespace {

constexpr double kDistance = 1.25;  // in D

template <class Use>
void for_each_corner(const TriangleMesh& mesh, Use use) {
    for (const Triangle& t : mesh.triangles)
        for (std::uint32_t v : t)
            use(mesh.positions[v]);
}

Eigen::AlignedBox3d box_of(const TriangleMesh& mesh) {
    Eigen::AlignedBox3d box;
    for_each_corner(mesh, [&](const Eigen::Vector3d& p) { box.extend(p); });
    return box;
}

bool is_usable(const TriangleMesh& mesh, const Triangle& t) {
    const Eigen::Vector3d &a = mesh.positions[t[0]], &b = mesh.positions[t[1]],
                          &c = mesh.positions[t[2]];
    return a.allFinite() && b.allFinite() && c.allFinite() && (b - a).cross(c - a).norm() > 0;
}

Eigen::Matrix3d axes_towards(const Eigen::Vector3d& away) {
    const bool along_y = std::abs(away.normalized().y()) > 0.999;
    const Eigen::Vector3d up = along_y ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY();
    Eigen::Matrix3d axes;
    axes.row(0) = away.cross(up).normalized();
    axes.row(2) = away.normalized();
    axes.row(1) = axes.row(0).cross(axes.row(2));
    return axes;
}

}  // namespace

TriangleMesh without_unusable(const TriangleMesh& mesh) {
    TriangleMesh result{mesh.positions, {}};
    for (const Triangle& t : mesh.triangles)
        if (is_usable(mesh, t)) result.triangles.push_back(t);
    return result;
}

std::vector<View> views_around(const TriangleMesh& mesh, int count) {
    const Eigen::AlignedBox3d box = box_of(mesh);
    const double turn = std::acos(-1.0) * (3 - std::sqrt(5.0));  // a spiral over the sphere
    std::vector<View> views;
    for (int i = 0; i < count; ++i) {
        const double y = 1 - (2 * i + 1.0) / count, ring = std::sqrt(1 - y * y);
        const Eigen::Vector3d direction(ring * std::sin(turn * i), y, ring * std::cos(turn * i));
        views.push_back(
            i % 2 ? View::perspective(box.center() + kDistance * box.diagonal().norm() * direction)
                  : View::orthographic(direction));
    }
    return views;
}

PictureCamera::PictureCamera(const View& view, const TriangleMesh& mesh, int size, double filled)
    : view_(view), size_(size) {
    const Eigen::Vector3d centre = box_of(mesh).center();
    position_ = is_perspective() ? Eigen::Vector3d(view.eye / view.w) : centre;
    axes_ = axes_towards(is_perspective() ? Eigen::Vector3d(centre - position_)
                                          : Eigen::Vector3d(-view.eye));
    Eigen::AlignedBox2d shown;
    for_each_corner(mesh, [&](const Eigen::Vector3d& p) {
        const Eigen::Vector3d place = seen(p);
        if (is_perspective() && !(place.z() > 0))
            throw std::invalid_argument("the eye is not in front of the mesh");
        shown.extend(Eigen::Vector2d(place.head<2>()));
    });
    scale_ = filled * size / shown.sizes().maxCoeff();
    middle_ = shown.center();
}

Eigen::Vector3d PictureCamera::seen(const Eigen::Vector3d& point) const {
    Eigen::Vector3d p = axes_ * (point - position_);
    if (is_perspective()) p.head<2>() /= p.z();
    return p;
}

Eigen::Vector3d PictureCamera::project(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d p = seen(point);
    const Eigen::Vector2d place = scale_ * (p.head<2>() - middle_);
    return {size_ / 2.0 + place.x(), size_ / 2.0 - place.y(), p.z()};
}

}  // namespace benchmarks
