// SPDX-License-Identifier: GPL-3.0-or-later
// Δn and S against the smooth surfaces that meshes sample, also where the kernel is not a full disc
// of one surface: at borders and thin walls.
#include <gtest/gtest.h>

#include <cmath>

#include "helpers.h"
#include "laplacian_lines/precompute.h"
#include "reference.h"

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
            for (std::size_t axis = 0; axis < 3; ++axis)
                EXPECT_LT((a.shape_derivative[axis] - b.shape_derivative[axis]).norm(), 1e-9);
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

/// √h ∝ √ē: the kernel shrinks, but holds ever more vertices.
TEST(LaplacianConvergence, ErrorFallsUnderRefinement) {
    const struct {
        const char* name;
        AnalyticMesh (*generate)(int level);
        double finest_error;  // measured value plus about a third
    } families[] = {
        {"bumpy sphere", [](int l) { return test_meshes::bumpy_sphere(l + 4, 0.15); }, 0.14},
        {"torus", [](int l) { return test_meshes::torus(40 << l, 20 << l, 0.25); }, 0.05}};
    for (const auto& family : families) {
        double coarsest_edge = 0, previous = 1e9;
        for (int level = 0; level < 3; ++level) {
            const AnalyticMesh surface = family.generate(level);
            const double edge = reference::mean_edge(surface.mesh);
            if (level == 0) coarsest_edge = edge;
            PrecomputeOptions options;
            options.kernel_size = 1.5 * std::sqrt(edge * coarsest_edge);
            const double error =
                helpers::laplacian_error(precompute(surface.mesh, options), surface.truth);
            EXPECT_LT(error, 0.75 * previous) << family.name << ", level " << level;
            previous = error;
        }
        EXPECT_LT(previous, family.finest_error) << family.name;
    }
}

/// Δn has a part along the surface where the mean curvature changes; its sign is easily lost.
TEST(TorusLaplacian, TangentialPartIsTheGradientOfTheMeanCurvature) {
    const AnalyticMesh torus = test_meshes::torus(160, 80);
    const Field field = precompute(torus.mesh);
    std::vector<Eigen::Vector3f> found;
    std::vector<Eigen::Vector3d> expected;
    for (std::size_t v = 0; v < torus.truth.size(); ++v) {
        const Eigen::Vector3d n = torus.truth[v].normal, x = torus.truth[v].laplacian_normal;
        expected.push_back(x - n * n.dot(x));
        const Eigen::Vector3f& m = field.laplacian_normals[v];
        found.push_back(m - n.cast<float>() * n.cast<float>().dot(m));
    }
    EXPECT_LT(helpers::relative_error(found, expected), 0.02);
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

/// The paper's figure 2: the reason for the heat kernel.
TEST(CotangentLaplacian, BreaksDownOnIrregularMeshes) {
    const AnalyticMesh torus = test_meshes::torus(80, 40, 0.25);
    PrecomputeOptions options;
    options.kernel_size = 2 * measure_scale(torus.mesh).mean_edge;
    const double belkin = helpers::laplacian_error(precompute(torus.mesh, options), torus.truth);
    options.laplace_operator = LaplaceOperator::Cotangent;
    options.normal_smoothing = NormalSmoothing::None;
    EXPECT_GT(helpers::laplacian_error(precompute(torus.mesh, options), torus.truth), 20 * belkin);
}

class ShapeOperators : public testing::TestWithParam<GradientEstimator> {
protected:
    Field compute(const TriangleMesh& mesh) const {
        PrecomputeOptions options;
        options.normal_sigma = 0.8;
        options.gradient_estimator = GetParam();
        return precompute(mesh, options);
    }
};

TEST_P(ShapeOperators, ConvergeToTheTruth) {
    const auto error = [&](const AnalyticMesh& s) {
        return helpers::shape_error(compute(s.mesh), s.truth);
    };
    const double torus = error(test_meshes::torus(80, 40, 0.25));
    const double fine_torus = error(test_meshes::torus(160, 80, 0.25));
    EXPECT_LT(torus, 0.05);
    EXPECT_LT(fine_torus, 0.6 * torus);
}

TEST_P(ShapeOperators, TakeTheNormalToZero) {
    for (const std::string& name : test_meshes::mesh_names()) {
        const Field field = compute(test_meshes::mesh_named(name).mesh);
        for (std::size_t v = 0; v < field.normals.size(); ++v) {
            const double size = helpers::matrix(field.shape_operators[v]).norm();
            EXPECT_LE((field.shape_operators[v] * field.normals[v]).norm(), 1e-6 * size + 1e-12)
                << name << " vertex " << v;
        }
    }
}

TEST_P(ShapeOperators, AreZeroOnPlanes) {
    const Field field = compute(test_meshes::mesh_named("plane").mesh);
    for (const ShapeOperator& s : field.shape_operators)
        EXPECT_LT(helpers::matrix(s).norm(), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Estimators, ShapeOperators,
                         testing::Values(GradientEstimator::TriangleFit,
                                         GradientEstimator::LeastSquares),
                         [](const auto& info) {
                             return info.param == GradientEstimator::TriangleFit ? "TriangleFit"
                                                                                 : "LeastSquares";
                         });

/// Vertices of a half torus (0 <= u <= π) less than `reach` from the plane of its borders.
std::vector<bool> near_border(const TriangleMesh& half_torus, double reach) {
    std::vector<bool> near;
    for (const Eigen::Vector3d& p : half_torus.positions)
        near.push_back(p.y() < reach);
    return near;
}

double border_error(const test_meshes::AnalyticMesh& surface, bool correct, double reach) {
    PrecomputeOptions options;
    options.kernel_size = reach / 2;
    options.correct_borders = correct;
    return helpers::laplacian_error(precompute(surface.mesh, options), surface.truth,
                                    near_border(surface.mesh, reach));
}

TEST(Borders, CorrectionRemovesTheSpuriousTerm) {
    for (double jitter : {0.0, 0.2}) {
        const auto surface = test_meshes::half_torus(60, 60, jitter);
        const double reach = 2 * 2 * reference::mean_edge(surface.mesh);
        const double plain = border_error(surface, false, reach);
        const double corrected = border_error(surface, true, reach);
        EXPECT_GT(plain, 0.5) << "jitter " << jitter;
        EXPECT_LT(corrected, 0.2) << "jitter " << jitter;
    }
}

TEST(Borders, CorrectionLeavesTheInsideAlone) {
    const auto surface = test_meshes::half_torus(80, 80);
    PrecomputeOptions options;
    const Field corrected = precompute(surface.mesh, options);
    options.correct_borders = false;
    const Field plain = precompute(surface.mesh, options);
    std::vector<bool> inside = near_border(surface.mesh, 0.6);
    inside.flip();
    const double a = helpers::laplacian_error(corrected, surface.truth, inside);
    const double b = helpers::laplacian_error(plain, surface.truth, inside);
    EXPECT_LT(a, 0.03);
    EXPECT_LT(a, 1.1 * b);
}

TEST(ThinWalls, SmoothingTakesNoNormalsFromTheOppositeSheet) {
    PrecomputeOptions options;
    options.normal_sigma = 3;
    TriangleMesh mesh = test_meshes::parallel_sheets(40, 0.01);
    for (Eigen::Vector3d& p : mesh.positions)  // parallel normals would only shorten
        p.z() *= 1 + p.x() / 2;
    const Field field = precompute(mesh, options);
    const Eigen::Vector3f up = Eigen::Vector3f(-0.005f, 0, 1).normalized(), down(0, 0, -1);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        EXPECT_LT((field.normals[v] - (mesh.positions[v].z() > 0 ? up : down)).norm(), 1e-4);
}

/// The two sides of a shell: spheres of radius 1 facing out and 0.97 facing in.
TEST(ThinWalls, LeastSquaresTakeNoNormalsFromTheOppositeSheet) {
    const test_meshes::AnalyticMesh outer = test_meshes::sphere(4);
    const TriangleMesh inner = test_meshes::moved(outer.mesh, {0, 0, 0}, 0.97),
                       shell = test_meshes::together(outer.mesh, test_meshes::flipped(inner));
    PrecomputeOptions options;
    options.gradient_estimator = GradientEstimator::LeastSquares;
    EXPECT_LT(helpers::shape_error(precompute(shell, options), outer.truth), 0.02);
    options.skip_opposite_sheet = false;
    EXPECT_GT(helpers::shape_error(precompute(shell, options), outer.truth), 0.2);
}

}  // namespace
