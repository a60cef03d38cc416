// SPDX-License-Identifier: GPL-3.0-or-later
// Crest lines as they are usually defined, on forms whose crests are known.
#include "crest_lines.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "generators.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace benchmarks;
using namespace laplacian_lines;
using Eigen::Vector3d;

const Vector3d kHalfAxes = {1, 0.8, 0.6};

LineSet crests(const TriangleMesh& mesh, LineKind kind) {
    PrecomputeOptions options;
    options.curvature_derivatives = true;
    return crest_lines(mesh, precompute(mesh, options), kind);
}

TriangleMesh inside_out(TriangleMesh mesh) {
    for (Triangle& t : mesh.triangles)
        std::swap(t[0], t[1]);
    return mesh;
}

/// Turned in its triangles, so that none of their edges lie in a plane of symmetry.
TriangleMesh ellipsoid() {
    const auto turn = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized());
    TriangleMesh mesh = test_meshes::icosphere(5);
    for (Vector3d& p : mesh.positions)
        p = (turn * p).cwiseProduct(kHalfAxes);
    return mesh;
}

/// The length of the rim z = 0, and the integral of the curvature across it.
struct Rim {
    double length = 0, strength = 0;

    Rim() {
        constexpr int kSteps = 3600;
        constexpr double kStep = 2 * 3.14159265358979 / kSteps;
        for (int i = 0; i < kSteps; ++i) {
            const double x = std::cos(i * kStep), y = std::sin(i * kStep);
            const double ds = kStep * std::hypot(kHalfAxes.x() * y, kHalfAxes.y() * x);
            const double slope = std::hypot(x / kHalfAxes.x(), y / kHalfAxes.y());
            length += ds;
            strength += ds / (kHalfAxes.z() * kHalfAxes.z() * slope);
        }
    }
};

/// In the other planes of symmetry C(e₁, e₁, e₁) is zero too, where the larger curvature is
/// smallest; or it is the smaller one that is an extremum.
void expect_rim(const LineSet& lines, LineKind kind, double diagonal) {
    const Rim rim;
    ASSERT_EQ(lines.lines.size(), 1u);
    const Polyline& line = lines.lines[0];
    EXPECT_EQ(line.kind, kind);
    EXPECT_TRUE(line.closed);
    EXPECT_NEAR(line.length * diagonal, rim.length, 0.03 * rim.length);
    EXPECT_NEAR(line.strength, rim.strength, 0.04 * rim.strength);
    for (const LinePoint& p : lines.points)
        EXPECT_NEAR(p.position.z(), 0, 0.005);
}

TEST(CrestLines, OfAnEllipsoidAreItsRim) {
    const TriangleMesh mesh = ellipsoid();
    const double diagonal = 2 * kHalfAxes.norm();
    expect_rim(crests(mesh, LineKind::Ridge), LineKind::Ridge, diagonal);
    EXPECT_TRUE(crests(mesh, LineKind::Valley).lines.empty());
    expect_rim(crests(inside_out(mesh), LineKind::Valley), LineKind::Valley, diagonal);
    EXPECT_TRUE(crests(inside_out(mesh), LineKind::Ridge).lines.empty());
}

TEST(CrestLines, AreNoneOnSpheres) {
    for (const double jitter : {0., 0.2}) {
        const TriangleMesh mesh = test_meshes::sphere(5, 1, jitter).mesh;
        EXPECT_TRUE(crests(mesh, LineKind::Ridge).lines.empty()) << jitter;
        EXPECT_TRUE(crests(mesh, LineKind::Valley).lines.empty()) << jitter;
        EXPECT_TRUE(crests(inside_out(mesh), LineKind::Valley).lines.empty()) << jitter;
    }
}

/// A groove along x whose bottom is a valley.
TEST(CrestLines, FollowTheBottomsOfGrooves) {
    const TriangleMesh groove = test_meshes::grid_mesh({160, 160}, [](double u, double v) {
        const double x = 2 * u - 1, y = 2 * v - 1, across = y - 0.1 * std::sin(3 * x);
        return Vector3d(x, y, 0.3 * std::sqrt(across * across + 0.03 * 0.03));
    });
    const LineSet lines = lines_of_strength(crests(groove, LineKind::Valley), 5);
    ASSERT_EQ(lines.lines.size(), 1u);
    EXPECT_FALSE(lines.lines[0].closed);
    EXPECT_GT(lines.lines[0].length, 0.6);
    for (const LinePoint& p : lines.points)
        EXPECT_NEAR(p.position.y(), 0.1 * std::sin(3 * p.position.x()), 0.01);
}

/// Of one point each, with lengths and strengths of their own.
LineSet lines_with(const std::vector<std::pair<float, float>>& strengths_and_lengths) {
    LineSet lines;
    for (const auto& [strength, length] : strengths_and_lengths) {
        Polyline line{std::uint32_t(lines.points.size()), 1, LineKind::Ridge};
        line.strength = strength;
        line.length = length;
        lines.lines.push_back(line);
        lines.points.push_back({Eigen::Vector3f::Constant(strength), 1, 0, 1});
    }
    return lines;
}

TEST(CrestLines, AreKeptByTheirStrength) {
    const LineSet kept = lines_of_strength(lines_with({{4, 1}, {1, 1}, {16, 1}}), 4);
    ASSERT_EQ(kept.lines.size(), 2u);
    ASSERT_EQ(kept.points.size(), 2u);
    for (const Polyline& line : kept.lines)
        EXPECT_EQ(kept.points[line.first].position.x(), line.strength);
}

TEST(CrestLines, AreAsLongAsTheyShouldBe) {
    const LineSet lines = lines_with({{4, 2}, {1, 1}, {16, 1}});
    EXPECT_DOUBLE_EQ(strength_for_length(lines, 1.5), 8) << "16 is kept, and 4 is not";
    EXPECT_DOUBLE_EQ(strength_for_length(lines, 2.5), 2) << "3 is nearer than 1";
    EXPECT_DOUBLE_EQ(strength_for_length(lines, 9), 0);
    EXPECT_GT(strength_for_length(lines, 0), 16);
}

}  // namespace
