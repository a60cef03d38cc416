// SPDX-License-Identifier: GPL-3.0-or-later
// Normals, smoothed normals and adaptive kernels against the plain ones of reference_field.h.
#include <gtest/gtest.h>

#include <cmath>

#include "helpers.h"
#include "laplacian_lines/precompute.h"
#include "reference_field.h"

namespace {

using namespace laplacian_lines;
using helpers::plain_options;
using helpers::relative_error;

std::vector<double> constant(const TriangleMesh& mesh, double value) {
    return std::vector<double>(mesh.positions.size(), value);
}

TEST(NormalWeightings, MatchTheReference) {
    const TriangleMesh& mesh = test_meshes::mesh_named("bumpy_sphere").mesh;
    for (auto weighting : {NormalWeighting::Area, NormalWeighting::Angle, NormalWeighting::Max}) {
        PrecomputeOptions options = plain_options(0);
        options.normal_weighting = weighting;
        EXPECT_LT(
            relative_error(precompute(mesh, options).normals, reference::normals(mesh, weighting)),
            1e-7);
    }
}

class SmoothedNormals : public testing::TestWithParam<double> {};  // bilateral angle, 0: Gaussian

TEST_P(SmoothedNormals, MatchTheReference) {
    for (const char* name : {"bumpy_sphere", "torus_jittered", "hills"}) {
        const TriangleMesh& mesh = test_meshes::mesh_named(name).mesh;
        const double sigma = 1.3 * reference::mean_edge(mesh);
        PrecomputeOptions options = plain_options(0);
        options.normal_smoothing =
            GetParam() > 0 ? NormalSmoothing::Bilateral : NormalSmoothing::Gaussian;
        options.normal_sigma = 1.3;
        options.bilateral_angle = GetParam() > 0 ? GetParam() : 20;
        const auto expected =
            reference::smoothed(mesh, reference::normals(mesh, NormalWeighting::Area),
                                {constant(mesh, sigma), 3, GetParam()});
        const Field field = precompute(mesh, options);
        EXPECT_LT(relative_error(field.normals, expected), 1e-6) << name;
        EXPECT_NEAR(field.scale.normal_sigma, sigma, 1e-9) << name;
    }
}

INSTANTIATE_TEST_SUITE_P(Angles, SmoothedNormals, testing::Values(0.0, 8.0, 20.0, 90.0));

TEST(SmoothedNormals, BilateralKeepsTheEdgesOfACube) {
    const TriangleMesh& cube = test_meshes::mesh_named("cube").mesh;
    const auto off_axis = [&](NormalSmoothing smoothing) {
        PrecomputeOptions options;
        options.normal_smoothing = smoothing;
        options.normal_sigma = 2;
        const Field field = precompute(cube, options);
        double worst = 0;
        for (std::size_t v = 0; v < cube.positions.size(); ++v) {
            const Eigen::Array3d p = cube.positions[v].array().abs();
            if ((p > 0.99).count() != 1) continue;  // inside a face
            worst = std::max(worst, 1 - double(field.normals[v].cwiseAbs().maxCoeff()));
        }
        return worst;
    };
    EXPECT_LT(off_axis(NormalSmoothing::Bilateral), 1e-3);
    EXPECT_GT(off_axis(NormalSmoothing::Gaussian), 1e-2);
}

TEST(AdaptiveKernel, SizesAndLaplacianMatchTheReference) {
    // Triangles that differ in size by about ten times.
    const auto graded =
        test_meshes::grid_mesh({40, 40, false, false, 0.15}, [](double u, double v) {
            return test_meshes::hills_point(std::exp(2.3 * u) / 5 - 1, std::exp(2.3 * v) / 5 - 1);
        });
    PrecomputeOptions options = plain_options(0.1);
    options.kernel_mode = KernelMode::Adaptive;
    options.accuracy = 1e-4;
    const Field field = precompute(graded.mesh, options);
    std::vector<double> sizes = reference::relative_sizes(graded.mesh);
    double smallest = 1e9, largest = 0;
    for (std::size_t v = 0; v < sizes.size(); ++v) {
        sizes[v] *= 0.1;
        EXPECT_NEAR(field.kernel_sizes[v], sizes[v], 1e-6 * sizes[v]);
        smallest = std::min(smallest, sizes[v]);
        largest = std::max(largest, sizes[v]);
    }
    EXPECT_GT(largest, 4 * smallest);
    const auto expected = reference::laplacian(
        graded.mesh, reference::normals(graded.mesh, NormalWeighting::Area), sizes, false);
    EXPECT_LT(relative_error(field.laplacian_normals, expected), 1e-4);
}

TEST(AdaptiveKernel, ClampsToAQuarterAndFourTimes) {
    TriangleMesh mesh = test_meshes::icosphere(4), large = test_meshes::icosphere(1);
    for (Eigen::Vector3d& p : large.positions)
        p = 40 * p + Eigen::Vector3d(100, 0, 0);
    test_meshes::append(mesh, large);
    PrecomputeOptions options = plain_options(1);
    options.kernel_mode = KernelMode::Adaptive;
    const Field field = precompute(mesh, options);
    EXPECT_FLOAT_EQ(field.kernel_sizes.front(), 0.25f);
    EXPECT_FLOAT_EQ(field.kernel_sizes.back(), 4.f);
}

TEST(Scale, HoldsDiagonalMeanEdgeAndAutomaticKernel) {
    const TriangleMesh& mesh = test_meshes::mesh_named("bumpy_sphere").mesh;
    const FieldScale scale = precompute(mesh).scale, measured = measure_scale(mesh);
    const double edge = reference::mean_edge(mesh), diagonal = reference::diagonal(mesh);
    EXPECT_NEAR(scale.mean_edge, edge, 1e-12);
    EXPECT_NEAR(scale.diagonal, diagonal, 1e-12);
    EXPECT_NEAR(scale.kernel_size, std::max(2 * edge, 0.0045 * diagonal), 1e-9);
    EXPECT_NEAR(scale.normal_sigma, 0.8 * edge, 1e-12);
    EXPECT_DOUBLE_EQ(measured.diagonal, scale.diagonal);
    EXPECT_DOUBLE_EQ(measured.kernel_size, scale.kernel_size);
    EXPECT_DOUBLE_EQ(measured.mean_edge, scale.mean_edge);
    EXPECT_EQ(measured.normal_sigma, 0) << "known only once the surface is looked at";
}

TEST(Scale, AutomaticKernelHasTwoRegimes) {
    EXPECT_DOUBLE_EQ(automatic_kernel_size(0.1, 1), 0.2);
    EXPECT_DOUBLE_EQ(automatic_kernel_size(0.001, 1), 0.0045);
}

}  // namespace
