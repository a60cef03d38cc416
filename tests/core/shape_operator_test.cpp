// SPDX-License-Identifier: GPL-3.0-or-later
// S against the smooth surfaces, and what the gradient of the illumination makes of it.
#include <gtest/gtest.h>

#include <cmath>

#include "helpers.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace laplacian_lines;
using test_meshes::AnalyticMesh;

class ShapeOperators : public testing::TestWithParam<GradientEstimator> {
protected:
    Field compute(const TriangleMesh& mesh) const {
        PrecomputeOptions options;
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
    const double bumpy = error(test_meshes::bumpy_sphere(5, 0.15));
    const double fine_bumpy = error(test_meshes::bumpy_sphere(6, 0.15));
    EXPECT_LT(bumpy, 0.08);
    EXPECT_LT(fine_bumpy, 0.6 * bumpy);
}

TEST_P(ShapeOperators, TakeTheNormalToZero) {
    for (const test_meshes::MeshEntry& entry : test_meshes::all_entries()) {
        const test_meshes::TestMesh& mesh = entry.get();
        const Field field = compute(mesh.mesh);
        for (std::size_t v = 0; v < field.normals.size(); ++v) {
            const double size = helpers::matrix(field.shape_operators[v]).norm();
            EXPECT_LE((field.shape_operators[v] * field.normals[v]).norm(), 1e-6 * size + 1e-12)
                << mesh << " vertex " << v;
        }
    }
}

TEST_P(ShapeOperators, AreZeroOnPlanes) {
    const Field field = compute(test_meshes::mesh_named("plane").mesh);
    for (const ShapeOperator& s : field.shape_operators)
        EXPECT_LT(helpers::matrix(s).norm(), 1e-6);
}

/// ∇I = S l for a light at the eye: against differences of I on the smooth surface.
TEST_P(ShapeOperators, GiveTheGradientOfTheIllumination) {
    const AnalyticMesh torus = test_meshes::torus(160, 80);
    const Field field = compute(torus.mesh);
    const Eigen::Vector3d eye(1.5, -2.5, 2);
    const auto illumination = [&](double u, double v) {
        const auto p = test_meshes::closed_form_torus_point({}, u, v);
        return p.normal.dot(eye - p.position);
    };
    const double step = 1e-5, two_pi = 2 * std::acos(-1.0);
    double error = 0, size = 0;
    for (int j = 0; j < 80; j += 7)
        for (int i = 0; i < 160; i += 7) {
            const double u = two_pi * i / 160, v = two_pi * j / 80;
            const Eigen::Vector3d eu(-std::sin(u), std::cos(u), 0);
            const Eigen::Vector3d ev(-std::sin(v) * std::cos(u), -std::sin(v) * std::sin(u),
                                     std::cos(v));
            const Eigen::Vector3d expected =
                (illumination(u + step, v) - illumination(u - step, v)) /
                    (2 * step * (1 + 0.4 * std::cos(v))) * eu +
                (illumination(u, v + step) - illumination(u, v - step)) / (2 * step * 0.4) * ev;
            const std::size_t vertex = std::size_t(j * 160 + i);
            const Eigen::Vector3f l = (eye - torus.mesh.positions[vertex]).cast<float>();
            const Eigen::Vector3f gradient = field.shape_operators[vertex] * l;
            error += (gradient.cast<double>() - expected).squaredNorm();
            size += expected.squaredNorm();
        }
    EXPECT_LT(std::sqrt(error / size), 0.02);
}

INSTANTIATE_TEST_SUITE_P(Estimators, ShapeOperators,
                         testing::Values(GradientEstimator::TriangleFit,
                                         GradientEstimator::LeastSquares),
                         [](const auto& info) {
                             return info.param == GradientEstimator::TriangleFit ? "TriangleFit"
                                                                                 : "LeastSquares";
                         });

TEST(LeastSquares, FallsBackToTheTriangleFitWhereTheBallIsEmpty) {
    PrecomputeOptions options;
    const TriangleMesh& mesh = test_meshes::mesh_named("single_triangle").mesh;
    const Field fit = precompute(mesh, options);
    options.gradient_estimator = GradientEstimator::LeastSquares;
    options.gradient_radius = 1;
    const Field ball = precompute(mesh, options);
    for (std::size_t v = 0; v < 3; ++v)
        EXPECT_LT(
            (helpers::matrix(fit.shape_operators[v]) - helpers::matrix(ball.shape_operators[v]))
                .norm(),
            1e-6);
}

}  // namespace
