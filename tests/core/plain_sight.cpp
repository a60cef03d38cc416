// SPDX-License-Identifier: GPL-3.0-or-later
#include "plain_sight.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <sstream>

namespace plain_sight {

using Eigen::Vector2d;
using Eigen::Vector3d;
using laplacian_lines::LineKind;
using laplacian_lines::Triangle;

namespace {

/// Along a ray; NaN if it misses.
double meeting(const TriangleMesh& mesh, const Triangle& t, const Vector3d& origin,
               const Vector3d& direction) {
    const double nowhere = std::numeric_limits<double>::quiet_NaN();
    const Vector3d &a = mesh.positions[t[0]], ab = mesh.positions[t[1]] - a,
                   ac = mesh.positions[t[2]] - a;
    const Vector3d p = direction.cross(ac), s = origin - a, q = s.cross(ab);
    const double determinant = ab.dot(p);
    if (determinant == 0) return nowhere;
    const double u = s.dot(p) / determinant, v = direction.dot(q) / determinant;
    return u >= 0 && v >= 0 && u + v <= 1 ? ac.dot(q) / determinant : nowhere;
}

/// What is seen on a plane through `point`.
class SeenPlane {
public:
    SeenPlane(const View& view, const Vector3d& point)
        : view_(view),
          point_(point),
          normal_(towards_eye(view, point)),
          right_(normal_.unitOrthogonal()),
          up_(normal_.cross(right_)) {}

    Vector2d place(const Vector3d& p) const {
        Vector3d on = p - point_;
        if (view_.w != 0) {
            const Vector3d eye = view_.eye / view_.w - point_;
            on = eye + eye.dot(normal_) / (eye - on).dot(normal_) * (on - eye);
        }
        return {right_.dot(on), up_.dot(on)};
    }

private:
    const View& view_;
    const Vector3d point_, normal_, right_, up_;
};

double distance_to_segment(const Vector2d& a, const Vector2d& b) {
    const Vector2d direction = b - a;
    const double length = direction.squaredNorm();
    const double t = length > 0 ? std::clamp(-direction.dot(a) / length, 0., 1.) : 0;
    return (a + t * direction).norm();
}

}  // namespace

LineKindSet edge_kinds() {
    LineKindSet kinds;
    kinds[LineKind::Contour] = kinds[LineKind::Border] = kinds[LineKind::Crease] = true;
    return kinds;
}

Box box_of(const TriangleMesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t v : t)
            if (mesh.positions[v].allFinite()) box.extend(mesh.positions[v]);
    return {box.center(), box.diagonal().norm()};
}

std::vector<Vector3d> special_directions() {
    std::vector<Vector3d> directions;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (x != 0 || y != 0 || z != 0) directions.emplace_back(x, y, z);
    directions.insert(
        directions.end(),
        {{0.31, -0.74, 0.59}, {-0.45, -0.68, 0.35}, {0.93, 0.11, -0.27}, {-0.02, 0.37, 1}});
    return directions;
}

std::vector<View> views_from(const std::vector<Vector3d>& directions, const Box& box,
                             double distance) {
    std::vector<View> views;
    for (const Vector3d& d : directions) {
        views.push_back(View::orthographic(d));
        views.push_back(View::perspective(box.centre + distance * box.diagonal * d.normalized()));
    }
    return views;
}

std::string words(const View& view) {
    std::ostringstream out;
    out.precision(17);
    out << "eye " << view.eye.transpose() << ", w " << view.w;
    return out.str();
}

Vector3d towards_eye(const View& view, const Vector3d& point) {
    return (view.eye - view.w * point).normalized();
}

bool is_hidden(const TriangleMesh& mesh, const View& view, const Vector3d& point, double least) {
    const Vector3d direction = towards_eye(view, point);
    const double most =
        view.w != 0 ? (view.eye / view.w - point).norm() : std::numeric_limits<double>::infinity();
    return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
        const double at = meeting(mesh, t, point, direction);
        return at > least && at < most;
    });
}

bool is_before_mesh(const TriangleMesh& mesh, const View& view, const Vector3d& point) {
    const Vector3d direction = towards_eye(view, point);
    return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
        const double at = meeting(mesh, t, point, direction);
        return view.w != 0 ? at < (view.eye / view.w - point).norm() : at == at;
    });
}

OutlinePlace place_in_outlines(const std::vector<SightLine>& lines, const View& view,
                               const Vector3d& point) {
    const SeenPlane plane(view, point);
    OutlinePlace result{false, std::numeric_limits<double>::infinity()};
    for (const SightLine& line : lines) {
        if (!line.is_outline) continue;
        for (std::size_t i = 1; i < line.points.size(); ++i) {
            const Vector2d a = plane.place(line.points[i - 1].position),
                           b = plane.place(line.points[i].position);
            result.distance = std::min(result.distance, distance_to_segment(a, b));
            const bool passes = (a.y() > 0) != (b.y() > 0);
            if (passes && a.x() - a.y() * (b.x() - a.x()) / (b.y() - a.y()) > 0)
                result.is_inside = !result.is_inside;
        }
    }
    return result;
}

}  // namespace plain_sight
