// SPDX-License-Identifier: GPL-3.0-or-later
// Demarcating curves: on reliefs whose flanks are known, and against a plain extraction.
#include <gtest/gtest.h>

#include <cmath>

#include "fixed/demarcation.h"
#include "helpers.h"
#include "laplacian_lines/precompute.h"
#include "mesh_noise.h"
#include "plain_derivatives.h"

namespace {

using namespace laplacian_lines;

const View kView = View::orthographic(Eigen::Vector3d::UnitZ());

LineStyle only_demarcating_curves() {
    LineStyle style;
    style.shows = {};
    style.shows[LineKind::DemarcatingCurve] = true;
    style.fading = 0;
    style.line_smoothing = 0;
    return style;
}

LineSet curves(const TriangleMesh& mesh, const LineStyle& style = only_demarcating_curves()) {
    return helpers::extract(LineExtractor(mesh, helpers::complete_field(mesh)), kView, style);
}

/// A plate with a round step of the given height, its middle at the radius 0.5.
TriangleMesh relief(double height, double jitter = 0, int cells = 120) {
    test_meshes::Grid grid{cells, cells};
    grid.jitter = jitter;
    return test_meshes::grid_mesh(grid, [=](double u, double v) {
        const double x = 2 * u - 1, y = 2 * v - 1;
        return Eigen::Vector3d(x, y, -height * std::tanh((std::hypot(x, y) - 0.5) / 0.08));
    });
}

TEST(DemarcatingCurves, FollowTheMiddleOfFlanks) {
    for (const double jitter : {0., 0.2}) {
        const LineSet lines = curves(relief(0.05, jitter));
        double length = 0;
        for (const Polyline& line : lines.lines) {
            EXPECT_EQ(line.kind, LineKind::DemarcatingCurve);
            length += line.length * std::sqrt(8.01);
        }
        EXPECT_NEAR(length, 3.14159, 0.15) << "all around, once";
        double error = 0;
        for (const LinePoint& p : lines.points)
            error += std::abs(p.position.head<2>().norm() - 0.5);
        EXPECT_LT(error / double(lines.points.size()), 0.005) << jitter;
    }
}

TEST(DemarcatingCurves, AreThoseOfHollowsToo) {
    const LineSet bulge = curves(relief(0.05)), hollow = curves(relief(-0.05));
    ASSERT_FALSE(bulge.lines.empty());
    EXPECT_NEAR(helpers::total_length(bulge), helpers::total_length(hollow), 0.02);
}

TEST(DemarcatingCurves, AreLeftOutWhereTheReliefIsGentle) {
    const TriangleMesh mesh = relief(0.05);
    LineStyle style = only_demarcating_curves();
    const LineSet all = curves(mesh, style);
    float most = 0, least = 1e9f;
    for (const LinePoint& p : all.points)
        most = std::max(most, p.gradient), least = std::min(least, p.gradient);
    EXPECT_GE(least, style.demarcation / 2);
    EXPECT_GT(most, style.demarcation);
    style.demarcation = 1.01 * most;
    EXPECT_TRUE(curves(mesh, style).lines.empty());
    style.detail = 90;
    EXPECT_FALSE(curves(mesh, style).lines.empty());
    EXPECT_TRUE(curves(relief(0.0005)).lines.empty());
}

TEST(DemarcatingCurves, AreNotOnPlanesSpheresAndNoise) {
    EXPECT_TRUE(curves(test_meshes::mesh_named("plane").mesh).lines.empty());
    EXPECT_TRUE(curves(test_meshes::sphere(5).mesh).lines.empty());
    EXPECT_TRUE(curves(mesh_noise::with_noise(test_meshes::sphere(5).mesh, 0.2)).lines.empty());
}

TEST(DemarcatingCurves, NeedTheDerivatives) {
    const TriangleMesh mesh = relief(0.05);
    const Field field = precompute(mesh);
    EXPECT_TRUE(helpers::extract(LineExtractor(mesh, field), kView, only_demarcating_curves())
                    .lines.empty());
}

/// With all thresholds off: the pieces of a loop over all triangles, but those of short lines.
TEST(DemarcatingCurves, AreThoseOfAPlainLoop) {
    LineStyle style = only_demarcating_curves();
    style.demarcation = style.shortest_line = 0;
    for (const TriangleMesh& mesh : {relief(0.05, 0.2, 60), test_meshes::bumpy_sphere(4, 0.15).mesh,
                                     test_meshes::hills(40).mesh}) {
        const Field field = helpers::complete_field(mesh);
        const LineSet lines = helpers::extract(LineExtractor(mesh, field), kView, style);
        const auto pieces = reference::demarcating_pieces(mesh, field);
        ASSERT_GT(lines.points.size(), 100u);
        std::size_t missing = 0;
        const float edge = float(field.scale.mean_edge);
        for (const LinePoint& p : lines.points) {
            float nearest = edge, strength = 0;
            for (const auto& piece : pieces)
                for (int end : {0, 1}) {
                    const float d = (piece.ends[end].cast<float>() - p.position).norm();
                    if (d < nearest) nearest = d, strength = float(piece.strength[end]);
                }
            if (nearest > 2e-4f * edge ||
                std::abs(strength - p.gradient) > 1e-3f * strength + 1e-4f)
                ++missing;
        }
        EXPECT_LE(missing, lines.points.size() / 500);  // where rounding decides
        double plain = 0;
        for (const auto& piece : pieces)
            plain += (piece.ends[0] - piece.ends[1]).norm() / field.scale.diagonal;
        const double fast = helpers::total_length(lines);
        EXPECT_LE(fast, 1.001 * plain);
        EXPECT_GE(fast, 0.8 * plain);
    }
}

TEST(SteepestBend, IsTheLargestMaximum) {
    for (const float angle : {0.1f, 1.3f, 3.f, 5.5f}) {
        const float x = std::cos(angle), y = std::sin(angle);
        const SteepestBend bend = steepest_bend({x * x * x, x * x * y, x * y * y, y * y * y});
        EXPECT_NEAR(bend.slope, 1, 1e-5);
        EXPECT_NEAR(bend.direction.x(), x, 1e-3);
        EXPECT_NEAR(bend.direction.y(), y, 1e-3);
    }
}

TEST(SteepestBend, IsNoneWhereThreeAreEqual) {
    EXPECT_EQ(steepest_bend({1, 0, -1, 0}).slope, 0);  // cos 3θ
    EXPECT_EQ(steepest_bend({0, 0, 0, 0}).slope, 0);
    EXPECT_GT(steepest_bend({2, 0, -1, 0}).slope, 0);
}

}  // namespace
