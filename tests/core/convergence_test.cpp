// SPDX-License-Identifier: GPL-3.0-or-later
// Δn under refinement against the smooth surfaces that meshes sample. Figures: docs/accuracy.md.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <ostream>

#include "helpers.h"
#include "laplacian_lines/precompute.h"
#include "reference_field.h"

namespace {

using namespace laplacian_lines;
using test_meshes::AnalyticMesh;
using test_meshes::SurfacePoint;

TEST(Truth, TorusChartMatchesClosedFormulas) {
    for (double u : {0.1, 2.0, 4.4})
        for (double v : {0.0, 0.7, 3.0, 5.1}) {
            const SurfacePoint a = test_meshes::torus_point({1, 0.4}, u, v);
            const SurfacePoint b = test_meshes::closed_form_torus_point({1, 0.4}, u, v);
            EXPECT_LT((a.position - b.position).norm(), 1e-12);
            EXPECT_LT((a.normal - b.normal).norm(), 1e-12);
            EXPECT_LT((a.laplacian_normal - b.laplacian_normal).norm(), 1e-11);
            EXPECT_LT((a.shape_operator - b.shape_operator).norm(), 1e-12);
        }
}

TEST(Truth, SphereHasTheSignsOfTheCore) {
    const AnalyticMesh sphere = test_meshes::sphere(1, 2.0);
    for (const SurfacePoint& p : sphere.truth) {
        EXPECT_LT((p.normal - p.position / 2).norm(), 1e-12);
        EXPECT_LT((p.laplacian_normal + 2 / 4.0 * p.normal).norm(), 1e-11);
        EXPECT_NEAR(p.shape_operator.trace(), 2 / 2.0, 1e-12);
    }
}

struct Refinement {
    const char* name;
    std::function<AnalyticMesh(int level)> generate;
    double finest_error;  ///< measured value plus about a third
};

std::ostream& operator<<(std::ostream& out, const Refinement& r) {
    return out << r.name;
}

class LaplacianConvergence : public testing::TestWithParam<Refinement> {};

/// √h ∝ √ē: the kernel shrinks, but holds ever more vertices.
TEST_P(LaplacianConvergence, ErrorFallsUnderRefinement) {
    double coarsest_edge = 0, previous = 1e9;
    for (int level = 0; level < 3; ++level) {
        const AnalyticMesh surface = GetParam().generate(level);
        const double edge = reference::mean_edge(surface.mesh);
        if (level == 0) coarsest_edge = edge;
        PrecomputeOptions options;
        options.kernel_size = 1.5 * std::sqrt(edge * coarsest_edge);
        const double error =
            helpers::laplacian_error(precompute(surface.mesh, options), surface.truth);
        EXPECT_LT(error, 0.75 * previous) << "level " << level;
        previous = error;
    }
    EXPECT_LT(previous, GetParam().finest_error);
}

INSTANTIATE_TEST_SUITE_P(
    Surfaces, LaplacianConvergence,
    testing::Values(
        Refinement{"ellipsoid", [](int l) { return test_meshes::ellipsoid(l + 3); }, 0.14},
        Refinement{"bumpy_sphere_jittered",
                   [](int l) { return test_meshes::bumpy_sphere(l + 4, 0.15); }, 0.14},
        Refinement{"torus", [](int l) { return test_meshes::torus(40 << l, 20 << l); }, 0.045},
        Refinement{"torus_jittered",
                   [](int l) { return test_meshes::torus(40 << l, 20 << l, 0.25); }, 0.05}),
    [](const auto& info) { return info.param.name; });

/// N. Max's weights are exact on a sphere, so only the operator's error is left. Weights that fade
/// with the turn of normals would add about 12 h² / R⁴.
TEST(SphereLaplacian, ExactNormalsLeaveLessThanAThousandth) {
    for (int level : {3, 4, 5}) {
        const AnalyticMesh sphere = test_meshes::sphere(level);
        PrecomputeOptions options;
        options.normal_weighting = NormalWeighting::Max;
        options.normal_smoothing = NormalSmoothing::None;
        options.skip_opposite_sheet = false;
        options.kernel_size = 1.5 * std::sqrt(reference::mean_edge(sphere.mesh) * 0.15);
        EXPECT_LT(helpers::laplacian_error(precompute(sphere.mesh, options), sphere.truth), 2e-3);
    }
}

/// Δn has a part along the surface where the mean curvature changes; its sign is easily lost.
TEST(TorusLaplacian, TangentialPartIsTheGradientOfTheMeanCurvature) {
    const AnalyticMesh torus = test_meshes::torus(160, 80);
    const Field field = precompute(torus.mesh);
    double error = 0, size = 0;
    for (std::size_t v = 0; v < torus.truth.size(); ++v) {
        const Eigen::Vector3d n = torus.truth[v].normal;
        const auto tangential = [&](const Eigen::Vector3d& x) { return x - n * n.dot(x); };
        const Eigen::Vector3d expected = tangential(torus.truth[v].laplacian_normal);
        error += (tangential(field.laplacian_normals[v].cast<double>()) - expected).squaredNorm();
        size += expected.squaredNorm();
    }
    EXPECT_LT(std::sqrt(error / size), 0.02);
}

TEST(FlatLaplacian, IsZeroOnPlanes) {
    for (bool correct_borders : {false, true}) {
        PrecomputeOptions options;
        options.correct_borders = correct_borders;
        const Field field = precompute(test_meshes::mesh_named("plane").mesh, options);
        for (const Eigen::Vector3f& x : field.laplacian_normals)
            EXPECT_LT(x.norm(), 1e-5);
    }
}

TEST(CotangentLaplacian, MatchesTheSphere) {
    const AnalyticMesh sphere = test_meshes::sphere(4);
    PrecomputeOptions options;
    options.laplace_operator = LaplaceOperator::Cotangent;
    options.normal_weighting = NormalWeighting::Max;
    options.normal_smoothing = NormalSmoothing::None;
    EXPECT_LT(helpers::laplacian_error(precompute(sphere.mesh, options), sphere.truth), 0.02);
}

/// The paper's figure 2: the reason for the heat kernel.
TEST(CotangentLaplacian, BreaksDownOnIrregularMeshes) {
    const AnalyticMesh torus = test_meshes::torus(80, 40, 0.25);
    PrecomputeOptions options;
    const double belkin = helpers::laplacian_error(precompute(torus.mesh, options), torus.truth);
    options.laplace_operator = LaplaceOperator::Cotangent;
    options.normal_smoothing = NormalSmoothing::None;
    EXPECT_GT(helpers::laplacian_error(precompute(torus.mesh, options), torus.truth), 20 * belkin);
}

}  // namespace
