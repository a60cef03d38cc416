// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/ray_caster.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "laplacian_lines/error.h"

namespace laplacian_lines {
namespace {

// Rays through an edge must not slip between its triangles, whatever the rounding.
constexpr double kOverlap = 1e-10;
constexpr double kListed = 0.2;  // about the part of the building's time that the triangles take

/// T. Möller, B. Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997.
/// Where along the ray; NaN if nowhere.
double meets_at(const Ray& ray, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                const Eigen::Vector3d& c) {
    constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
    const Eigen::Vector3d ab = b - a, ac = c - a, from_a = ray.origin - a;
    const Eigen::Vector3d p = ray.direction.cross(ac);
    const double determinant = ab.dot(p);
    if (determinant == 0) return kNowhere;
    const double u = from_a.dot(p) / determinant;
    const Eigen::Vector3d q = from_a.cross(ab);
    const double v = ray.direction.dot(q) / determinant;
    if (!(u >= -kOverlap && v >= -kOverlap && u + v <= 1 + kOverlap)) return kNowhere;
    const double t = ac.dot(q) / determinant;
    return t >= 0 && t <= ray.length ? t : kNowhere;
}

bool meets_box(const Ray& ray, const Eigen::Vector3d& inverse, const BoxTree::Box& box) {
    double enter = 0, leave = ray.length;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (box.min()[axis] - ray.origin[axis]) * inverse[axis];
        const double b = (box.max()[axis] - ray.origin[axis]) * inverse[axis];
        if (std::isnan(a) || std::isnan(b)) continue;  // along a side of the box: 0 · ∞
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    // Beside the slab of an axis that an endless ray is at right angles to, both are ∞.
    return std::isfinite(enter) && enter <= leave + kOverlap * std::abs(enter);
}

/// A. van Oosterom, J. Strackee, "The Solid Angle of a Plane Triangle", 1983. Positive where the
/// triangle shows its back.
double solid_angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    const double numerator = a.dot(b.cross(c));
    const double denominator = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    return 2 * std::atan2(numerator, denominator);
}

}  // namespace

/// What the tree asks: which boxes to look into, and whether to stop at an object.
class RayCaster::Query {
public:
    Query(const Ray& ray, const std::vector<Corners>& triangles)
        : ray_(ray), inverse_(ray.direction.cwiseInverse()), triangles_(triangles) {}

    bool intersectVolume(const BoxTree::Box& box) const { return meets_box(ray_, inverse_, box); }

    bool intersectObject(int triangle) {
        const Corners& t = triangles_[std::size_t(triangle)];
        if (std::isnan(meets_at(ray_, t.a, t.b, t.c))) return false;
        met_ = triangle;
        return true;
    }

    /// The triangle that was met, -1 if none.
    int met() const { return met_; }

private:
    const Ray& ray_;
    Eigen::Vector3d inverse_;
    const std::vector<Corners>& triangles_;
    int met_ = -1;
};

/// Looks for the triangle nearest to the middle.
class RayCaster::MiddleQuery {
public:
    MiddleQuery(const Ray& ray, const std::vector<Corners>& triangles)
        : ray_(ray), inverse_(ray.direction.cwiseInverse()), triangles_(triangles) {}

    bool intersectVolume(const BoxTree::Box& box) const { return meets_box(ray_, inverse_, box); }
    bool intersectObject(int triangle) {
        const Corners& t = triangles_[std::size_t(triangle)];
        const double distance = std::abs(meets_at(ray_, t.a, t.b, t.c) - ray_.length / 2);
        if (std::isnan(distance)) return false;
        // of two at the same distance, at an edge, the first one, whatever the tree's order
        if (distance < distance_ || (distance == distance_ && triangle < nearest_)) {
            distance_ = distance;
            nearest_ = triangle;
        }
        return false;
    }

    Eigen::Vector3d normal() const {
        if (nearest_ < 0) return Eigen::Vector3d::Zero();
        const Corners& t = triangles_[std::size_t(nearest_)];
        return (t.b - t.a).cross(t.c - t.a).stableNormalized();
    }

private:
    const Ray& ray_;
    Eigen::Vector3d inverse_;
    const std::vector<Corners>& triangles_;
    int nearest_ = -1;
    double distance_ = std::numeric_limits<double>::infinity();
};

RayCaster::RayCaster(const TriangleMesh& mesh, const StageProgress& stage) {
    stage.report(0);
    std::vector<BoxTree::Box> boxes;
    triangles_.reserve(mesh.triangles.size());
    boxes.reserve(mesh.triangles.size());
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t corner : triangle)
            if (corner >= mesh.positions.size())
                throw Error(ErrorCode::InvalidMesh, "A triangle names a vertex that is not there.");
        const Corners corners = {mesh.positions[triangle[0]], mesh.positions[triangle[1]],
                                 mesh.positions[triangle[2]]};
        if (!corners.a.allFinite() || !corners.b.allFinite() || !corners.c.allFinite()) continue;
        triangles_.push_back(corners);
        boxes.push_back(BoxTree::Box(corners.a).extend(corners.b).extend(corners.c));
    }
    tree_ = BoxTree(boxes, stage.part(kListed, 1));
    stage.report(1);
}

bool RayCaster::is_hit(const Ray& ray, Hint& hint) const {
    if (triangles_.empty()) return false;
    Query query(ray, triangles_);
    if (hint.triangle >= 0 && query.intersectObject(hint.triangle)) return true;
    tree_.visit(query);
    if (query.met() >= 0) hint.triangle = query.met();
    return query.met() >= 0;
}

Eigen::Vector3d RayCaster::normal_near_middle(const Ray& ray) const {
    if (triangles_.empty()) return Eigen::Vector3d::Zero();
    MiddleQuery query(ray, triangles_);
    tree_.visit(query);
    return query.normal();
}

double RayCaster::winding_number(const Eigen::Vector3d& point) const {
    double sum = 0;
    for (const Corners& t : triangles_)
        sum += solid_angle(t.a - point, t.b - point, t.c - point);
    return sum / (4 * std::acos(-1.0));
}

}  // namespace laplacian_lines
