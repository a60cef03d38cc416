// SPDX-License-Identifier: GPL-3.0-or-later
// Demarcating curves: on reliefs whose flanks are known, and nowhere without flanks.
#include <gtest/gtest.h>

#include <cmath>

#include "helpers.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace laplacian_lines;

const View kView = View::orthographic(Eigen::Vector3d::UnitZ());

LineStyle only_demarcating_curves() {
    LineStyle style = helpers::only(LineKind::DemarcatingCurve);
    style.fading = 0;
    style.line_smoothing = 0;
    return style;
}

LineSet curves(const TriangleMesh& mesh, const LineStyle& style = only_demarcating_curves()) {
    return helpers::extract(LineExtractor(mesh, helpers::complete_field(mesh)), kView, style);
}

/// A plate with a round step, 2 · half_height high, its middle at the radius 0.5.
TriangleMesh relief(double half_height, double jitter = 0) {
    test_meshes::Grid grid{120, 120};
    grid.jitter = jitter;
    return test_meshes::grid_mesh(grid, [=](double u, double v) {
        const double x = 2 * u - 1, y = 2 * v - 1;
        return Eigen::Vector3d(x, y, -half_height * std::tanh((std::hypot(x, y) - 0.5) / 0.08));
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
        EXPECT_NEAR(length, M_PI, 0.15) << "all around, once";
        double error = 0;
        for (const LinePoint& p : lines.points)
            error += std::abs(p.position.head<2>().norm() - 0.5);
        EXPECT_LT(error / double(lines.points.size()), 0.005) << jitter;
    }
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
    EXPECT_TRUE(curves(test_meshes::with_noise(test_meshes::sphere(5).mesh, 0.2)).lines.empty());
}

}  // namespace
