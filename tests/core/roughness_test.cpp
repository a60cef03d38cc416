// SPDX-License-Identifier: GPL-3.0-or-later
// How rough a surface is, and the smoothing that follows from it.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "helpers.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace laplacian_lines;
using Eigen::Vector3d;

constexpr int kVoxels = 60;

const TriangleMesh& terraces() {
    static const TriangleMesh mesh = test_meshes::terraced_head(kVoxels);
    return mesh;
}

/// In mean edges.
double sigma_of(const Field& field) {
    return field.scale.normal_sigma / field.scale.mean_edge;
}
double sigma_of(const TriangleMesh& mesh) {
    return sigma_of(precompute(mesh));
}

/// Of all that is drawn by default, whether hidden or not; in D.
double drawn_length(const TriangleMesh& mesh, const PrecomputeOptions& options) {
    const Field field = precompute(mesh, options);
    const double d = field.scale.diagonal;
    const LineSet lines = helpers::extract(LineExtractor(mesh, field),
                                           View::perspective(d * Vector3d(0.5, 0.3, 1.4)), {});
    double length = 0;  // as drawn, after smoothing, unlike helpers::total_length()
    for (const Polyline& line : lines.lines)
        for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i)
            length += double((lines.points[i].position - lines.points[i - 1].position).norm()) / d;
    return length;
}

TEST(Roughness, OfCleanMeshesIsNoneAndLeavesNormalsAsTheyAre) {
    for (const std::string& name : test_meshes::mesh_names()) {
        if (name == "triangle_soup") continue;  // nothing but noise
        EXPECT_EQ(precompute(test_meshes::mesh_named(name).mesh).report.roughness, 0) << name;
    }
    for (const int size : {25, 30, 40, kVoxels})
        EXPECT_EQ(sigma_of(test_meshes::smooth_head(size)), 0) << size;
}

TEST(Roughness, LeavesSmoothingToTheKernelOfFineMeshes) {
    const TriangleMesh mesh = test_meshes::sphere(5).mesh;
    PrecomputeOptions options;
    for (const auto& [edges, sigma] :
         {std::pair(1.3, 0.), {1.5, 0.75 * std::sqrt(0.56)}, {4., 0.8}}) {
        options.kernel_size = edges * measure_scale(mesh).mean_edge;
        EXPECT_NEAR(sigma_of(precompute(mesh, options)), sigma, 1e-6);
    }
}

TEST(Roughness, TellsTerracesAndNoiseOnSmoothForms) {
    const Field rough = precompute(terraces());
    EXPECT_GT(rough.report.roughness, 1.6);
    EXPECT_GT(sigma_of(rough), 1.2);
    EXPECT_LT(sigma_of(rough), 1.7);
    EXPECT_GT(sigma_of(test_meshes::terraced_head(100)), sigma_of(rough))
        << "more voxels: the same terraces on a form that is smoother at their scale";
    EXPECT_GT(sigma_of(test_meshes::with_noise(test_meshes::sphere(5).mesh, 0.4)), 1.6)
        << "more than 1.5 √.4: on so smooth a form, noise counts as terraces";
}

constexpr int kSteps = 8;

/// Treads and risers of size 1, each cut into three strips of squares.
TriangleMesh steps() {
    constexpr int kCuts = 3;
    const auto place = [](double i) {  // along treads and risers in turn
        const double step = std::floor(i / (2 * kCuts)), rest = i - 2 * kCuts * step;
        return std::pair(step + std::min(rest / kCuts, 1.), step + std::max(rest / kCuts - 1, 0.));
    };
    const int pieces = 2 * kCuts * kSteps;
    return test_meshes::grid_mesh({12, pieces}, [&](double u, double v) {
        const auto [x, y] = place(std::round(pieces * v));
        return Vector3d(x, y, 4 * u);
    });
}

/// Steps on a wedge of large triangles.
TriangleMesh stairs() {
    return test_meshes::together(steps(), {{{0, 0, 0},
                                            {kSteps, 0, 0},
                                            {kSteps, 0, 4},
                                            {0, 0, 4},
                                            {kSteps, kSteps, 0},
                                            {kSteps, kSteps, 4}},
                                           {{{0, 1, 2}}, {{0, 2, 3}}, {{1, 4, 5}}, {{1, 5, 2}}}});
}

TEST(Roughness, IsNoneOfFineStepsOfADesign) {
    TriangleMesh many;  // so that no face is a large part of it
    for (int i = 0; i < 20; ++i)
        test_meshes::append(many, test_meshes::moved(stairs(), {12. * (i % 5), 0, 7. * (i / 5)}));
    EXPECT_EQ(precompute(many).report.roughness, 0);
    TriangleMesh turned;  // in more directions than voxels have
    for (int i = 0; i < 20; ++i) {
        const Eigen::AngleAxisd turn(0.3 * i, Vector3d(1, 2, 3).normalized());
        const auto part = test_meshes::mapped(steps(), [&](Vector3d& p) { p = turn * p; });
        test_meshes::append(turned, test_meshes::moved(part, {20. * (i % 5), 0, 20. * (i / 5)}));
    }
    EXPECT_EQ(precompute(turned).report.roughness, 0);
}

/// 1.5 times the root of the noise, in mean edges, on forms that turn too much, or meshes too
/// coarse, for noise to count as terraces.
TEST(Roughness, MeasuresNoise) {
    for (const TriangleMesh& mesh :
         {test_meshes::bumpy_sphere(4).mesh, test_meshes::cylinder(48, 24).mesh,
          test_meshes::parallel_sheets(24, 0.05)})
        for (const double noise : {0.1, 0.2})
            EXPECT_NEAR(sigma_of(test_meshes::with_noise(mesh, noise)), 1.5 * std::sqrt(noise),
                        0.15 * std::sqrt(noise));
}

/// Edges turned by noise are not the form's.
TEST(Roughness, HasNoisyCoarseMeshesDrawnWithSmoothContours) {
    const TriangleMesh bumps = test_meshes::bumpy_sphere(4).mesh;
    const double clean = drawn_length(bumps, {});
    EXPECT_NEAR(drawn_length(test_meshes::with_noise(bumps, 0.1), {}), clean, 0.5 * clean);
    EXPECT_NEAR(drawn_length(test_meshes::with_noise(bumps, 0.2), {}), clean, 0.8 * clean);
}

TEST(Roughness, IsOverriddenByASigma) {
    PrecomputeOptions options;
    options.normal_sigma = 3;
    EXPECT_NEAR(sigma_of(precompute(terraces(), options)), 3, 1e-9);
    EXPECT_NEAR(measure_scale(terraces(), options).normal_sigma,
                3 * measure_scale(terraces()).mean_edge, 1e-9);
}

TEST(Roughness, GivesTheFieldOfTheSigmaThatItChooses) {
    const Field field = precompute(terraces());
    PrecomputeOptions options;
    options.normal_sigma = field.scale.normal_sigma / field.scale.mean_edge;
    EXPECT_TRUE(helpers::same_fields(field, precompute(terraces(), options)));
}

TEST(Roughness, HasTerracesDrawnWithAsManyLinesAsTheSmoothForm) {
    PrecomputeOptions little;
    little.normal_sigma = 0.4;
    const double smooth = drawn_length(test_meshes::smooth_head(80), {});
    const TriangleMesh terraced = test_meshes::terraced_head(80);
    EXPECT_NEAR(drawn_length(terraced, {}), smooth, 0.2 * smooth);
    EXPECT_GT(drawn_length(terraced, little), 1.2 * smooth);
}

}  // namespace
