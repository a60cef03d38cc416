// SPDX-License-Identifier: GPL-3.0-or-later
// The stones whose arrises are known: one surface at all resolutions, arrises where it turns.
#include "flaked_stone.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "closed_mesh.h"
#include "generators.h"
#include "mesh_noise.h"

namespace {

using namespace test_meshes;
using Eigen::Vector3d;
using mesh_noise::with_noise;

constexpr double kDegrees = 57.29577951308232;

double angle_between(const Vector3d& a, const Vector3d& b) {
    return std::acos(std::clamp(a.dot(b), -1., 1.)) * kDegrees;
}

class Stones : public testing::TestWithParam<unsigned> {
protected:
    const FlakedStone stone_{{GetParam()}};
};
INSTANTIATE_TEST_SUITE_P(Seeds, Stones, testing::Values(1, 2));

TEST_P(Stones, AreClosedAndFaceOutwards) {
    const TriangleMesh mesh = stone_.mesh(4);
    EXPECT_EQ(mesh.triangles.size(), 20u * 256);
    EXPECT_EQ(helpers::edges_without_partner(mesh), 0u);
    EXPECT_GT(helpers::volume(mesh), 0.05 * std::pow(stone_.diagonal(), 3));
}

TEST_P(Stones, AreTheSameSurfaceAtAllResolutions) {
    for (const int level : {1, 3, 4})
        for (const Vector3d& p : stone_.mesh(level).positions)
            ASSERT_NEAR(stone_.wall(p).distance, 0, 1e-9) << "level " << level;
}

/// Smooth normals on both sides of an arris, beyond its rounding and amid it.
struct ArrisSides {
    double turn, turn_amid;  ///< degrees
    bool same_face;

    ArrisSides(const FlakedStone& stone, const ArrisPiece& piece) {
        const Vector3d across = (piece.b - piece.a).cross(piece.normal).normalized();
        const auto at = [&](double radii) {
            const Vector3d p = piece.middle() + radii * stone.edge_radius() * across;
            return onto_surface([&](const Vector3d& q) { return stone.wall(q); }, p);
        };
        const auto turn_between = [&](const Vector3d& a, const Vector3d& b) {
            return angle_between(stone.wall(a).normal, stone.wall(b).normal);
        };
        turn = turn_between(at(-2), at(2));
        turn_amid = turn_between(at(-0.05), at(0.05));
        same_face = stone.face(at(-2).normalized()) == stone.face(at(2).normalized());
    }
};

/// Faces are bent, hence the small radius; at corners a third face may interfere.
TEST_P(Stones, TurnByTheAngleAcrossTheirArrises) {
    const FlakedStone stone({GetParam(), 0.002});
    double right = 0, all = 0;
    const std::vector<ArrisPiece> arrises = find_arrises(stone, 15, 5);
    for (std::size_t i = 0; i < arrises.size(); i += 5) {
        const ArrisPiece& piece = arrises[i];
        EXPECT_NEAR(stone.wall(piece.a).distance, 0, 1e-9);
        const ArrisSides sides(stone, piece);
        all += piece.length();
        // Amid the rounding, an arc of the radius: a tenth of the radius is 5.7 degrees.
        const bool is_rounded = std::abs(sides.turn_amid - 0.1 * kDegrees) < 1;
        if (std::abs(sides.turn - piece.angle) < 2 && is_rounded && !sides.same_face)
            right += piece.length();
    }
    EXPECT_GT(all, stone.diagonal());
    EXPECT_GT(right, 0.8 * all);
}

TEST(RoundedIntersection, HasTheRadiusAtAnyAngle) {
    const double radius = 0.1;
    for (const double degrees : {20., 60., 90., 130.}) {
        const double half = degrees / 2 / kDegrees;
        const Solid solid = [&](const Vector3d& p) {
            const Vector3d n(std::sin(half), 0, std::cos(half)),
                m(-std::sin(half), 0, std::cos(half));
            return rounded_intersection({{n.dot(p), n}, {m.dot(p), m}}, radius);
        };
        const Vector3d axis(0, 0, -radius / std::cos(half));
        for (double turn = -0.9; turn <= 0.91; turn += 0.3) {
            const Vector3d n(std::sin(turn * half), 0, std::cos(turn * half));
            const Wall wall = solid(axis + 1.05 * radius * n);
            EXPECT_NEAR(wall.distance, 0.05 * radius, 1e-12) << degrees;
            EXPECT_LT((wall.normal - n).norm(), 1e-9) << degrees;
        }
    }
}

TEST(Noise, MovesEachVertexByTheShareOfAnEdge) {
    const TriangleMesh mesh = torus(80, 40).mesh;
    const TriangleMesh noisy = with_noise(mesh, 0.2), other = with_noise(mesh, 0.2, 2);
    double edges = 0;
    for (const Triangle& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            edges += (mesh.positions[t[k]] - mesh.positions[t[(k + 1) % 3]]).norm();
    const double edge = edges / double(3 * mesh.triangles.size());
    Vector3d sum = Vector3d::Zero();
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const Vector3d move = noisy.positions[v] - mesh.positions[v];
        EXPECT_NEAR(move.norm(), 0.2 * edge, 1e-3 * edge);
        sum += move / move.norm();
    }
    EXPECT_LT(sum.norm(), 0.1 * double(mesh.positions.size()));
    EXPECT_EQ(with_noise(mesh, 0.2).positions, noisy.positions);
    EXPECT_NE(other.positions, noisy.positions);
}

}  // namespace
