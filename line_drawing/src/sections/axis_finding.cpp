// SPDX-License-Identifier: GPL-3.0-or-later
#include "sections/half_section.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "views/drawn_view.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using laplacian_lines::Triangle;
using laplacian_lines::TriangleMesh;

constexpr int rounds = 30, rounds_in_space = 10;
constexpr std::size_t most_in_space = 50000;  // triangles; more tell nothing else
constexpr double least_miss = 1e-3;           // of the size: misses below it weigh the same
constexpr double near_miss = 0.25;  // of the distance: of normals that meet the axis, 15 degrees
constexpr double rim_share = 0.1;   // of the height
constexpr int directions = 72;      // around the axis
constexpr int parts_of_side = 8;
constexpr double turn = 6.283185307179586;

/// Along the axis: a triangle's middle, and its normal turned by 90 degrees, as long as the part of
/// its area that faces sideways.
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

/// The point that the facets' normals miss least, by the sum of misses, not of their squares.
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

double shareThatMeets(const std::vector<Facet>& facets, const Vector2d& axis) {
    double all = 0, meeting = 0;
    for (const Facet& facet : facets) {
        const double area = facet.across.norm();
        const Vector2d from_axis = facet.middle - axis;
        all += area;
        if (std::abs(facet.across.dot(from_axis)) < near_miss * area * from_axis.norm())
            meeting += area;
    }
    return all > 0 ? meeting / all : 0;
}

/// The line that all normals miss least, in any direction: a normal n at p meets the line of
/// direction d and moment m if d · (p × n) + m · n = 0. Returns d.
Vector3d directionOfAxis(const TriangleMesh& mesh, const Vector3d& middle, double size) {
    using Matrix6 = Eigen::Matrix<double, 6, 6>;
    using Vector6 = Eigen::Matrix<double, 6, 1>;
    Vector6 line = Vector6::Zero();
    const std::size_t step = mesh.triangles.size() / most_in_space + 1;
    for (int round = 0; round < rounds_in_space; ++round) {
        Matrix6 sum = Matrix6::Zero();
        for (std::size_t i = 0; i < mesh.triangles.size(); i += step) {
            const Triangle& t = mesh.triangles[i];
            const Vector3d &a = mesh.positions[t[0]], &b = mesh.positions[t[1]],
                           &c = mesh.positions[t[2]];
            const Vector3d area = (b - a).cross(c - a), normal = area.stableNormalized();
            if (!area.allFinite() || normal.isZero()) continue;
            Vector6 row;
            row << ((a + b + c) / 3 - middle).cross(normal) / size, normal;
            const double miss = std::abs(row.dot(line));
            sum +=
                area.norm() / (round == 0 ? 1 : std::max(miss, least_miss)) * row * row.transpose();
        }
        const Eigen::Matrix3d of_moments = sum.bottomRightCorner<3, 3>(),
                              mixed = sum.topRightCorner<3, 3>();
        const Eigen::Matrix3d moments = -of_moments.ldlt().solve(mixed.transpose());
        const Eigen::Matrix3d misses = sum.topLeftCorner<3, 3>() + mixed * moments;
        const Vector3d direction =
            Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(misses).eigenvectors().col(0);
        line << direction, moments * direction;
    }
    return line.head<3>();
}

/// From the surface's lower or upper end along `up`.
double shareOfRim(const TriangleMesh& mesh, const Eigen::AlignedBox3d& box, int up, bool looks_up,
                  const Vector2d& axis) {
    const int x = (up + 1) % 3, y = (up + 2) % 3;
    const double reach = rim_share * box.sizes()[up];
    std::array<bool, directions> is_there{};
    const auto add = [&](const Vector3d& p) {
        const double depth = looks_up ? box.max()[up] - p[up] : p[up] - box.min()[up];
        if (!(depth <= reach)) return;
        const double angle = std::atan2(p[y] - axis.y(), p[x] - axis.x());
        is_there[std::size_t(std::floor((angle / turn + 0.5) * directions)) % directions] = true;
    };
    for (const Triangle& t : mesh.triangles)
        for (int side = 0; side < 3; ++side)  // coarse ones reach over several directions
            for (int part = 0; part < parts_of_side; ++part) {
                const Vector3d &a = mesh.positions[t[std::size_t(side)]],
                               &b = mesh.positions[t[std::size_t(side + 1) % 3]];
                add(a + double(part) / parts_of_side * (b - a));
            }
    return double(std::count(is_there.begin(), is_there.end(), true)) / directions;
}

}  // namespace

VesselAxis findAxis(const TriangleMesh& mesh, int up, bool looks_up) {
    const int x = (up + 1) % 3, y = (up + 2) % 3;
    const Eigen::AlignedBox3d box = boundsOf(mesh);
    VesselAxis axis{box.center()};
    Vector3d& point = axis.point;
    const std::vector<Facet> facets = facetsOf(mesh, up);
    const Vector2d found = meetingPoint(facets, {point[x], point[y]}, box.sizes().maxCoeff());
    const bool is_inside = found.x() > box.min()[x] && found.x() < box.max()[x] &&
                           found.y() > box.min()[y] && found.y() < box.max()[y];
    if (is_inside) point[x] = found.x(), point[y] = found.y();
    point[up] = 0;
    const Vector2d seen(point[x], point[y]);
    axis.round = shareThatMeets(facets, seen);
    const Vector3d own = directionOfAxis(mesh, box.center(), box.sizes().maxCoeff());
    axis.lean = std::acos(std::min(1.0, std::abs(own[up]))) * 360 / turn;
    axis.rim = shareOfRim(mesh, box, up, looks_up, seen);
    return axis;
}

}  // namespace line_drawing
