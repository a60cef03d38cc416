// SPDX-License-Identifier: GPL-3.0-or-later
#include "sections/axis_finding.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "views/drawn_view.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using laplacian_lines::Triangle;
using laplacian_lines::TriangleMesh;

constexpr int rounds = 30;
constexpr double least_miss = 1e-3;  // of the size: misses below it weigh the same

/// Seen along the axis: a triangle's middle, and its normal turned by 90 degrees, as long as the
/// part of its area that faces sideways.
struct Facet {
    Vector2d middle, across;
};

std::vector<Facet> facetsOf(const TriangleMesh& mesh, int up) {
    const int x = (up + 1) % 3, y = (up + 2) % 3;
    std::vector<Facet> facets;
    for (const Triangle& t : mesh.triangles) {
        const Vector3d &a = mesh.positions.at(t[0]), &b = mesh.positions.at(t[1]),
                       &c = mesh.positions.at(t[2]);
        const Vector3d normal = (b - a).cross(c - a), middle = (a + b + c) / 3;
        if (normal.allFinite() && !normal.isZero())
            facets.push_back({{middle[x], middle[y]}, {-normal[y], normal[x]}});
    }
    return facets;
}

/// The point that the facets' normals miss least: the sum of misses, not of their squares.
Vector2d meetingPoint(const std::vector<Facet>& facets, Vector2d point, double size) {
    for (int round = 0; round < rounds; ++round) {
        Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
        Vector2d right = Vector2d::Zero();
        for (const Facet& facet : facets) {
            const double area = facet.across.norm();
            if (area == 0) continue;
            const Vector2d across = facet.across / area;
            const double miss = std::abs(across.dot(point - facet.middle));
            const Vector2d weighted = area / std::max(miss, least_miss * size) * across;
            sum += weighted * across.transpose();
            right += weighted * across.dot(facet.middle);
        }
        if (!(std::abs(sum.determinant()) > 1e-6 * sum.squaredNorm())) return point;
        point = sum.inverse() * right;
    }
    return point;
}

}  // namespace

Vector3d findAxis(const TriangleMesh& mesh, int up) {
    const int x = (up + 1) % 3, y = (up + 2) % 3;
    const Eigen::AlignedBox3d box = boundsOf(mesh);
    Vector3d axis = box.center();
    const Vector2d found =
        meetingPoint(facetsOf(mesh, up), {axis[x], axis[y]}, box.sizes().maxCoeff());
    const bool is_inside = found.x() > box.min()[x] && found.x() < box.max()[x] &&
                           found.y() > box.min()[y] && found.y() < box.max()[y];
    if (is_inside) axis[x] = found.x(), axis[y] = found.y();
    axis[up] = 0;
    return axis;
}

}  // namespace line_drawing
