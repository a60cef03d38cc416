// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/winding_number.h"

#include <Eigen/Geometry>
#include <cmath>

namespace laplacian_lines {
namespace {

using Eigen::Vector3d;

/// A. van Oosterom, J. Strackee, "The Solid Angle of a Plane Triangle", 1983. Positive where the
/// triangle shows its back.
double solid_angle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    const double numerator = a.dot(b.cross(c));
    const double denominator = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    return 2 * std::atan2(numerator, denominator);
}

}  // namespace

double winding_number(const SightMesh& mesh, const Vector3d& point) {
    const double sum = sum_of(mesh.triangles.size(), [&](std::size_t i) {
        const Triangle& t = mesh.triangles[i];
        return solid_angle(mesh.positions[t[0]] - point, mesh.positions[t[1]] - point,
                           mesh.positions[t[2]] - point);
    });
    return sum / (4 * std::acos(-1.0));
}

}  // namespace laplacian_lines
