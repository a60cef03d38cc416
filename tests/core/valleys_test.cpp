// SPDX-License-Identifier: GPL-3.0-or-later
// Valleys: the crest lines of concave edges, which are the ridges of the surface seen from within.
#include <gtest/gtest.h>

#include <cmath>

#include "fixed/ridge_candidates.h"
#include "helpers.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace laplacian_lines;
using test_meshes::inside_out;

const View kView = View::orthographic(Eigen::Vector3d::UnitZ());

LineStyle only(LineKind kind) {
    LineStyle style;
    style.shows = {};
    style.shows[kind] = true;
    style.fading = 0;
    style.ridge_angle = 10;
    return style;
}

LineSet lines_of(const TriangleMesh& mesh, LineKind kind) {
    return helpers::extract(LineExtractor(mesh, precompute(mesh)), kView, only(kind));
}

/// A plate with a wavy groove at y = 0.1 sin 3x.
TriangleMesh groove() {
    return test_meshes::grid_mesh({160, 160}, [](double u, double v) {
        const double x = 2 * u - 1, y = 2 * v - 1, across = y - 0.1 * std::sin(3 * x);
        return Eigen::Vector3d(x, y, 0.3 * std::sqrt(across * across + 0.03 * 0.03));
    });
}

TEST(Valleys, FollowTheBottomsOfGrooves) {
    const LineSet lines = lines_of(groove(), LineKind::Valley);
    ASSERT_FALSE(lines.lines.empty());
    for (const LinePoint& p : lines.points)
        EXPECT_NEAR(p.position.y(), 0.1 * std::sin(3 * p.position.x()), 0.01);
    EXPECT_GT(helpers::total_length(lines), 0.7);
    for (const Polyline& line : lines.lines)
        EXPECT_EQ(line.kind, LineKind::Valley);
    EXPECT_TRUE(lines_of(groove(), LineKind::Ridge).lines.empty());
}

TEST(Valleys, AreTheRidgesOfTheOtherSide) {
    for (const TriangleMesh& mesh : {groove(), test_meshes::hills(80).mesh}) {
        const LineSet valleys = lines_of(inside_out(mesh), LineKind::Valley),
                      ridges = lines_of(mesh, LineKind::Ridge);
        EXPECT_EQ(valleys.lines.size(), ridges.lines.size());
        EXPECT_NEAR(helpers::total_length(valleys), helpers::total_length(ridges),
                    1e-3 * helpers::total_length(ridges));
        for (const LinePoint& p : valleys.points)
            EXPECT_LT(helpers::distance_to_lines(p.position.cast<double>(), ridges), 1e-3);
    }
}

TEST(Valleys, AreNoneOnPlanesAndRoundForms) {
    for (const char* name : {"plane", "sphere", "bumpy_sphere"})
        EXPECT_TRUE(lines_of(test_meshes::mesh_named(name).mesh, LineKind::Valley).lines.empty())
            << name;
}

/// Of an ellipsoid they are in its planes of symmetry: where it is bent most, around its rim.
TEST(Valleys, OfAnEllipsoidSeenFromWithinAreItsRim) {
    TriangleMesh mesh = test_meshes::icosphere(5);
    for (Eigen::Vector3d& p : mesh.positions)
        p = p.cwiseProduct(Eigen::Vector3d(1, 0.8, 0.2));
    mesh = test_meshes::cavity(mesh);
    const ExtractorData data = build_extractor_data(mesh, precompute(mesh));
    const auto found = find_ridge_candidates(data, place_clusters(data), kConcaveCrest);
    double rim = 0;
    for (const LinePoint& p : found.lines.points) {
        if (std::abs(p.position.z()) > 0.1) continue;  // elsewhere other planes may have crests
        EXPECT_NEAR(p.position.z(), 0, 0.02);
        ++rim;
    }
    EXPECT_GT(rim, 100);
    EXPECT_TRUE(
        find_ridge_candidates(data, place_clusters(data), kConvexCrest).lines.lines.empty());
}

}  // namespace
