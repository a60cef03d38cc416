// SPDX-License-Identifier: GPL-3.0-or-later
#include "machined_part.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "closed_mesh.h"
#include "generators.h"

namespace {

using namespace test_meshes;
using Eigen::Vector3d;

/// The block less step, slot and hole.
constexpr double kSharpVolume = 2 * 1.2 * 0.8 - 0.6 * 1.2 * 0.4 - 0.3 * 1.2 * 0.3;
constexpr double kHoleArea = 0.2 * 0.2 * 3.14159265358979;

TEST(MachinedParts, AreClosedAndOnTheSurfaceAtAllResolutions) {
    for (const double radius : {0.005, 0.02}) {
        const MachinedPart part(radius);
        for (const double edge : {0.024, 0.012}) {
            const TriangleMesh mesh = part.mesh(edge);
            EXPECT_EQ(helpers::edges_without_partner(mesh), 0u) << radius << ' ' << edge;
            EXPECT_NEAR(helpers::volume(mesh), kSharpVolume - kHoleArea * 0.4, 0.02);
            for (const Vector3d& p : mesh.positions)
                ASSERT_NEAR(part.wall(p).distance, 0, 1e-9);
        }
    }
}

/// The length of its sharp edges: 10 corners of the profile across, the profile twice, two rims.
TEST(MachinedParts, HaveAllEdgesAtRightAngles) {
    const double across = 10 * 1.2, profiles = 2 * (2 * (2 + 0.8) + 2 * 0.3),
                 rims = 4 * kHoleArea / 0.2;
    for (const double radius : {0., 0.01}) {
        const std::vector<ArrisPiece> arrises = MachinedPart(radius).arrises();
        EXPECT_NEAR(total_length(arrises), across + profiles + rims, 0.03 * (across + profiles));
        double concave = 0;
        for (const ArrisPiece& piece : arrises) {
            EXPECT_EQ(piece.angle, 90);
            EXPECT_LT(piece.length(), 0.008 * MachinedPart::diagonal());
            concave += piece.convex ? 0 : piece.length();
        }
        EXPECT_NEAR(concave, 3 * 1.2, 0.05);
    }
}

/// Across a fillet, the normal turns by the distance over the radius, outwards or inwards.
TEST(MachinedParts, HaveFilletsOfTheRadius) {
    const double share = 0.01, radius = share * MachinedPart::diagonal();
    const MachinedPart part(share);
    const Solid solid = [&](const Vector3d& p) { return part.wall(p); };
    std::size_t right = 0, all = 0;
    for (const ArrisPiece& piece : part.arrises()) {
        const Vector3d across = (piece.b - piece.a).cross(piece.normal).normalized();
        const Vector3d a = onto_surface(solid, piece.middle() - 0.2 * radius * across),
                       b = onto_surface(solid, piece.middle() + 0.2 * radius * across);
        const Vector3d turn = part.wall(b).normal - part.wall(a).normal;
        const double curvature = turn.dot(b - a) / (b - a).squaredNorm();
        ++all;
        right += std::abs(curvature * radius - (piece.convex ? 1 : -1)) < 0.1;
        EXPECT_GT(part.wall(piece.middle()).normal.dot(piece.normal), 0.6);
    }
    EXPECT_GT(double(right), 0.85 * double(all));  // the others are at corners
}

TEST(SharpParts, AreTheSameWithFewTriangles) {
    const TriangleMesh mesh = sharp_part();
    EXPECT_EQ(mesh.triangles.size(), 180u);
    EXPECT_EQ(helpers::edges_without_partner(mesh), 0u);
    const double hole = 16 * std::sin(2 * 3.14159265358979 / 32) * 0.04;  // of 32 sides
    EXPECT_NEAR(helpers::volume(mesh), kSharpVolume - hole * 0.4, 1e-9);
    const MachinedPart sharp(0);
    for (const Vector3d& p : mesh.positions)
        EXPECT_NEAR(sharp.wall(p).distance, 0, 1e-9);
}

}  // namespace
