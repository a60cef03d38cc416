// SPDX-License-Identifier: GPL-3.0-or-later
// A vessel in half section, as archaeologists draw it: the wall cut open on the left, the outside
// on the right, with the axis between them.
//  1. find_axis(): the line that the surface's normals meet, along the vertical and in space.
//  2. It is refused if too little is round about it, if it leans, or if most of the rim is gone.
//  3. The mesh is cut in the plane of the picture; walls, rim, base and axis follow from that.
#include "sections/half_section.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "line_drawing/words.h"
#include "sections/wall_area.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using laplacian_lines::Triangle;
using laplacian_lines::TriangleMesh;

constexpr int kRounds = 30, kRoundsInSpace = 10;  // of reweighting
constexpr std::size_t kMostInSpace = 50000;       // triangles; more do not change the axis
constexpr double kLeastMiss = 1e-3;               // of the size: smaller distances weigh the same
constexpr double kNearMiss = 0.25;  // of the radius: normals that meet the axis; 15 degrees
constexpr double kOtherAxis = 60;   // degrees: another axis of the mesh is nearer
// Limits of VesselAxis. Of a cube .25 is round; a pot of 200 mm that leans by 5 degrees has its
// section 9 mm off its axis at both ends.
constexpr double kLeastRound = 0.4, kLeastRim = 0.5, kMostLean = 5;
constexpr double kRimShare = 0.1;  // of the height
constexpr int kDirections = 72;    // around the axis
constexpr int kPartsOfSide = 16;
constexpr double kTurn = 6.283185307179586;  // radians

/// A triangle seen along the axis: its centre, and its normal turned by 90 degrees, as long as
/// twice the part of its area that faces sideways.
struct Facet {
    Vector2d middle, across;
};

std::vector<Facet> facets_of(const TriangleMesh& mesh, int up) {
    const int x = (up + 1) % 3, y = (up + 2) % 3;
    std::vector<Facet> facets;
    for (const Triangle& t : mesh.triangles) {
        const Vector3d &a = mesh.positions.at(t[0]), &b = mesh.positions.at(t[1]),
                       &c = mesh.positions.at(t[2]);
        const Vector3d normal = (b - a).cross(c - a), middle = (a + b + c) / 3;
        if (normal.allFinite()) facets.push_back({{middle[x], middle[y]}, {-normal[y], normal[x]}});
    }
    return facets;
}

/// The point with the least sum of distances (not of their squares) from the facets' normals.
Vector2d meeting_point(const std::vector<Facet>& facets, Vector2d point, double size) {
    for (int round = 0; round < kRounds; ++round) {
        Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
        Vector2d right = Vector2d::Zero();
        for (const Facet& facet : facets) {
            const double area = facet.across.norm();
            if (area == 0) continue;
            const Vector2d across = facet.across / area;
            const double miss = std::abs(across.dot(point - facet.middle));
            const Vector2d weighted = area / std::max(miss, kLeastMiss * size) * across;
            sum += weighted * across.transpose();
            right += weighted * across.dot(facet.middle);
        }
        if (!(std::abs(sum.determinant()) > 1e-6 * sum.squaredNorm())) return point;
        point = sum.inverse() * right;
    }
    return point;
}

double share_that_meets(const std::vector<Facet>& facets, const Vector2d& axis) {
    double all = 0, meeting = 0;
    for (const Facet& facet : facets) {
        const double area = facet.across.norm();
        const Vector2d from_axis = facet.middle - axis;
        all += area;
        if (std::abs(facet.across.dot(from_axis)) < kNearMiss * area * from_axis.norm())
            meeting += area;
    }
    return all > 0 ? meeting / all : 0;
}

/// The line nearest to all normals, in any direction: a normal n at p meets the line of direction d
/// and moment m if d · (p × n) + m · n = 0. Returns d. Normals are at the middles of sides, not of
/// triangles: two triangles of a flat face lie to either side of its middle, one above the other.
Vector3d direction_of_axis(const TriangleMesh& mesh, const Vector3d& middle, double size) {
    using Matrix6 = Eigen::Matrix<double, 6, 6>;
    using Vector6 = Eigen::Matrix<double, 6, 1>;
    Vector6 line = Vector6::Zero();
    const std::size_t step = mesh.triangles.size() / kMostInSpace + 1;
    for (int round = 0; round < kRoundsInSpace; ++round) {
        Matrix6 sum = Matrix6::Zero();
        for (std::size_t i = 0; i < mesh.triangles.size(); i += step) {
            const Triangle& t = mesh.triangles[i];
            const Vector3d &a = mesh.positions[t[0]], &b = mesh.positions[t[1]],
                           &c = mesh.positions[t[2]];
            const Vector3d area = (b - a).cross(c - a), normal = area.stableNormalized();
            if (!area.allFinite() || normal.isZero()) continue;
            for (const Vector3d& ends : {Vector3d(a + b), Vector3d(b + c), Vector3d(c + a)}) {
                Vector6 row;
                row << (ends / 2 - middle).cross(normal) / size, normal;
                const double miss = std::abs(row.dot(line));
                sum += area.norm() / (round == 0 ? 1 : std::max(miss, kLeastMiss)) * row *
                       row.transpose();
            }
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

/// Share of the directions around the axis with surface near its lower or upper end along `up`.
double share_of_rim(const TriangleMesh& mesh, const Eigen::AlignedBox3d& box, int up, bool looks_up,
                    const Vector3d& axis) {
    const int x = (up + 1) % 3, y = (up + 2) % 3;
    const double reach = kRimShare * box.sizes()[up];
    std::array<bool, kDirections> is_there{};
    const auto add = [&](const Vector3d& p) {
        const double depth = looks_up ? box.max()[up] - p[up] : p[up] - box.min()[up];
        if (!p.allFinite() || depth > reach) return;
        const double angle = std::atan2(p[y] - axis[y], p[x] - axis[x]);
        is_there[std::size_t(std::floor((angle / kTurn + 0.5) * kDirections)) % kDirections] = true;
    };
    for (const Triangle& t : mesh.triangles)
        for (int side = 0; side < 3; ++side)  // large triangles cover several directions
            for (int part = 0; part < kPartsOfSide; ++part) {
                const Vector3d &a = mesh.positions[t[std::size_t(side)]],
                               &b = mesh.positions[t[std::size_t(side + 1) % 3]];
                add(a + double(part) / kPartsOfSide * (b - a));
            }
    return double(std::count(is_there.begin(), is_there.end(), true)) / kDirections;
}

/// An axis along one of the mesh, through the place that normals meet, or else the middle of the
/// bounding box: its point and `round` alone.
VesselAxis seen_axis(const TriangleMesh& mesh, const Eigen::AlignedBox3d& box, int up) {
    const int x = (up + 1) % 3, y = (up + 2) % 3;
    const std::vector<Facet> facets = facets_of(mesh, up);
    const Vector2d middle(box.center()[x], box.center()[y]),
        found = meeting_point(facets, middle, box.sizes().maxCoeff());
    const bool is_inside = found.x() > box.min()[x] && found.x() < box.max()[x] &&
                           found.y() > box.min()[y] && found.y() < box.max()[y];
    const Vector2d& point = is_inside ? found : middle;
    VesselAxis axis;
    axis.point[x] = point.x(), axis.point[y] = point.y();
    axis.round = share_that_meets(facets, point);
    return axis;
}

/// The axis of the mesh about which most is round, as of a vessel, if it is not `up`, about which
/// `round` is.
std::optional<int> rounder_axis(const TriangleMesh& mesh, const Eigen::AlignedBox3d& box, int up,
                                double round) {
    std::optional<int> rounder;
    round = std::max(round, kLeastRound);
    for (const int axis : {(up + 1) % 3, (up + 2) % 3})
        if (const double own = seen_axis(mesh, box, axis).round; own > round)
            rounder = axis, round = own;
    return rounder;
}

/// The axis of revolution of a vessel along the mesh's axis `up`: the normals of a surface of
/// revolution meet its axis. Handles and spouts count little. `looks_up`: upright along `up`, or
/// upside down. By the linear complex of normals, H. Pottmann, T. Randrup, "Rotational and helical
/// surface approximation for reverse engineering", Computing 60 (1998), with iterated weights.
VesselAxis find_axis(const TriangleMesh& mesh, int up, bool looks_up) {
    const Eigen::AlignedBox3d box = bounds_of(mesh);
    VesselAxis axis = seen_axis(mesh, box, up);
    const Vector3d own = direction_of_axis(mesh, box.center(), box.sizes().maxCoeff());
    axis.lean = std::acos(std::min(1.0, std::abs(own[up]))) * 360 / kTurn;
    if (axis.lean > kOtherAxis) {
        axis.other = rounder_axis(mesh, box, up, axis.round);
        if (!axis.other) axis.lean.reset();  // flutes misled the line in space
    }
    axis.rim = share_of_rim(mesh, box, up, looks_up, axis.point);
    return axis;
}

constexpr double kLevelShare = 0.003;  // of the height: tolerance of the level of rim or base
constexpr double kLeastSpan = 0.1;     // of the height: a round base is not a line

std::string percent(double share) {
    return in_digits(std::floor(100 * share + 1e-9)) + " %";
}

int axis_along(const Vector3d& direction) {
    int axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    return axis;
}

DrawnLine line_of(const Vector2d& begin, const Vector2d& end) {
    return {LineClass::Inner, false, {{begin, 1}, {end, 1}}};
}

/// The outermost points near the height of the highest (`sign` 1) or lowest (−1) one.
struct Level {
    Vector2d left, right;
};
Level level_of(const std::vector<Vector2d>& points, double sign, double reach) {
    double height = -INFINITY;
    for (const Vector2d& p : points)
        height = std::max(height, sign * p.y());
    Level level{{INFINITY, 0}, {-INFINITY, 0}};
    for (const Vector2d& p : points) {
        if (sign * p.y() < height - reach) continue;
        if (p.x() < level.left.x()) level.left = p;
        if (p.x() > level.right.x()) level.right = p;
    }
    return level;
}

}  // namespace

HalfSection::HalfSection(const TriangleMesh& all, const ViewFrame& frame)
    : axis_(find_axis(all, axis_along(frame.up), frame.up.sum() > 0)),
      behind_{-frame.towards_viewer, -frame.towards_viewer.dot(axis_.point)},
      right_{frame.right, frame.right.dot(axis_.point)} {}

void HalfSection::expect_vessel() const {
    const auto say = [](const std::string& what) {
        refuse(what +
               " Vessel views take a vessel that stands upright, nearly whole. Fix that, or "
               "take other views and a section.");
    };
    if (axis_.other)
        refuse(std::string("The vessel stands along ") + "xyz"[*axis_.other] +
               ": choose this axis to point up.");
    if (axis_.round < kLeastRound)
        say("Of what faces sideways, only " + percent(axis_.round) + " is round about one axis.");
    if (axis_.lean > kMostLean)
        say("The vessel's axis leans by " + in_decimals(*axis_.lean, 0) + " degrees.");
    if (axis_.rim < kLeastRim)
        say("The rim goes only " + percent(axis_.rim) + " of the way around the axis.");
}

std::string HalfSection::words() const {
    return "rim " + percent(axis_.rim) +
           (axis_.lean ? ", axis off by " + in_decimals(*axis_.lean, 1) + "°" : "");
}

void HalfSection::draw(DrawnView& drawn, const std::vector<CuttableMesh>& objects,
                       const Vector3d& middle, double unit) const {
    const int across = axis_along(behind_.normal);
    const Projection projection(drawn.frame, middle);
    const auto flat = [&](const Cut& cut) { return positions_of(project(cut, projection, unit)); };
    std::vector<Vector2d> points;
    std::vector<CutObject> cut_objects;
    for (const CuttableMesh& object : objects) {
        CutObject parts;
        const std::vector<Cut> cuts = object.cut(across, axis_.point[across]);
        for (const Cut& cut : cuts) {
            const std::vector<Vector2d> line = flat(cut);
            points.insert(points.end(), line.begin(), line.end());
            const Cut loop = cut.front() == cut.back() ? clip_loop(cut, left()) : Cut();
            if (!loop.empty()) parts.wall.push_back(flat(loop));
        }
        drawn.lines = without_parts_in(WallArea(parts.wall), drawn.lines);
        for (const Cut& cut : clip(cuts, left()))
            parts.lines.push_back(project(cut, projection, unit));
        cut_objects.push_back(std::move(parts));
    }
    add_walls(std::move(cut_objects), drawn);
    if (points.empty()) return;
    const double height = drawn.bounds.sizes().y(), at = unit * right_.depth(middle);
    const Level rim = level_of(points, 1, kLevelShare * height),
                base = level_of(points, -1, kLevelShare * height);
    for (const Level& level : {rim, base})
        if (level.right.x() - level.left.x() > kLeastSpan * height)
            drawn.lines.push_back(line_of(level.left, level.right));
    drawn.lines.push_back(line_of({-at, rim.left.y()}, {-at, base.left.y()}));
}

}  // namespace line_drawing
