// SPDX-License-Identifier: GPL-3.0-or-later
// C = ∇S and S̄, the smoothed curvatures that come with it: against smooth surfaces and noise, and
// what they must not depend on.
#include <gtest/gtest.h>

#include <cmath>

#include "helpers.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace laplacian_lines;
using test_meshes::AnalyticMesh;

/// For S linear in the place, up to borders, and on a lone triangle far smaller than the fit, with
/// differences within it.
TEST(CurvatureDerivatives, AreExactOfLinearShapeOperators) {
    const TriangleMesh small = {{{3, 0, 0}, {3.002, 0, 0}, {3, 0.003, 0}}, {{0, 1, 2}}},
                       mesh = test_meshes::together(test_meshes::plane(20, 0.3), small);
    Field field = precompute(mesh);
    const Eigen::Vector4f c(3, -2, 1, 0.5f);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        ASSERT_GT(field.normals[v].z(), 0.999f);
        field.normals[v] = Eigen::Vector3f::UnitZ();
        const Eigen::Vector3f p = mesh.positions[v].cast<float>();
        ShapeOperator& s = field.shape_operators[v];
        s = {};
        s.xx = 0.3f + c[0] * p.x() + c[1] * p.y();
        s.xy = c[1] * p.x() + c[2] * p.y();
        s.yy = 0.1f + c[2] * p.x() + c[3] * p.y();
    }
    add_curvature_derivatives(mesh, field);
    const std::size_t last = mesh.positions.size() - 3;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        EXPECT_LT((field.curvature_derivatives[v] - c).norm(), v < last ? 1e-4 : 1e-2) << v;
}

TEST(CurvatureDerivatives, AreTheSameAddedLater) {
    for (const char* name : {"bumpy_sphere", "dirty_torus", "half_torus"}) {
        const TriangleMesh& mesh = test_meshes::mesh_named(name).mesh;
        Field later = precompute(mesh);
        EXPECT_TRUE(later.curvature_derivatives.empty());
        add_curvature_derivatives(mesh, later);
        EXPECT_TRUE(later.has_derivatives()) << name;
        EXPECT_TRUE(helpers::same_fields(later, helpers::complete_field(mesh))) << name;
        add_curvature_derivatives(mesh, later);
        EXPECT_TRUE(helpers::same_fields(later, helpers::complete_field(mesh))) << name;
    }
}

TEST(CurvatureDerivatives, OfVerticesOfCutsAreThoseAcrossThem) {
    const TriangleMesh whole = test_meshes::torus(40, 20).mesh;
    const TriangleMesh apart = test_meshes::cut_apart(whole);
    const Field expected = helpers::complete_field(whole), field = helpers::complete_field(apart);
    for (std::size_t t = 0; t < whole.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_LT((field.curvature_derivatives[apart.triangles[t][k]] -
                       expected.curvature_derivatives[whole.triangles[t][k]])
                          .norm(),
                      1e-2);
    Field later = precompute(apart);
    add_curvature_derivatives(apart, later);
    EXPECT_TRUE(helpers::same_fields(later, field));
}

TEST(CurvatureDerivatives, AreRefusedToAFieldOfAnotherMesh) {
    Field field = precompute(test_meshes::mesh_named("torus").mesh);
    EXPECT_THROW(add_curvature_derivatives(test_meshes::mesh_named("plane").mesh, field), Error);
    EXPECT_TRUE(field.curvature_derivatives.empty());
}

/// RMS over three entries of tensors, relative to the truth.
template <class Entries>
double error_of(const AnalyticMesh& surface, const Field& field, const Entries& entries) {
    double error = 0, size = 0;
    for (std::size_t v = 0; v < surface.truth.size(); ++v) {
        const Eigen::Vector3d truth =
            helpers::curvature_entries(surface.truth[v].shape_operator, field.normals[v]);
        const Eigen::Vector3d weights(1, 2, 1);  // the middle one stands for two
        error += (entries(v) - truth).cwiseAbs2().dot(weights);
        size += truth.cwiseAbs2().dot(weights);
    }
    return std::sqrt(error / size);
}

double smooth_error(const AnalyticMesh& surface, const Field& field) {
    return error_of(surface, field, [&](std::size_t v) -> Eigen::Vector3d {
        return field.smooth_curvatures[v].cast<double>();
    });
}

double raw_error(const AnalyticMesh& surface, const Field& field) {
    return error_of(surface, field, [&](std::size_t v) {
        return helpers::curvature_entries(helpers::matrix(field.shape_operators[v]),
                                          field.normals[v]);
    });
}

TEST(SmoothCurvatures, ConvergeToTheTruthAsDerivativesDo) {
    const struct {
        const char* name;
        AnalyticMesh (*make)(int level);
        double curvatures, derivatives;  // largest errors of the coarse one
    } families[] = {
        {"torus, jitter .25", [](int l) { return test_meshes::torus(80 << l, 40 << l, 0.25); },
         0.08, 0.24},
        {"ellipsoid", [](int l) { return test_meshes::ellipsoid(5 + l); }, 0.06, 0.19},
    };
    for (const auto& family : families) {
        double curvatures[2], derivatives[2];
        for (const int level : {0, 1}) {
            const AnalyticMesh surface = family.make(level);
            const Field field = helpers::complete_field(surface.mesh);
            curvatures[level] = smooth_error(surface, field);
            derivatives[level] = helpers::derivative_error(field, surface.truth);
        }
        EXPECT_LT(curvatures[0], family.curvatures) << family.name;
        EXPECT_LT(curvatures[1], 0.45 * curvatures[0]) << family.name;
        EXPECT_LT(derivatives[0], family.derivatives) << family.name;
        EXPECT_LT(derivatives[1], 0.4 * derivatives[0]) << family.name;
    }
}

TEST(SmoothCurvatures, HaveLessNoiseThanShapeOperators) {
    AnalyticMesh surface = test_meshes::sphere(6, 1);
    surface.mesh = test_meshes::with_noise(surface.mesh, 0.2);
    const Field field = helpers::complete_field(surface.mesh);
    EXPECT_LT(smooth_error(surface, field), 0.85 * raw_error(surface, field));
}

/// Older versions stored C alone.
TEST(SmoothCurvatures, AreAddedToFieldsThatHaveDerivativesAlone) {
    const TriangleMesh& mesh = test_meshes::mesh_named("bumpy_sphere").mesh;
    const Field complete = helpers::complete_field(mesh);
    EXPECT_TRUE(complete.has_derivatives());
    Field alone = complete;
    alone.smooth_curvatures.clear();
    EXPECT_FALSE(alone.has_derivatives());
    const View view = View::perspective(Eigen::Vector3d(0.5, 1, 4));
    for (const LineKind kind : {LineKind::SuggestiveContour, LineKind::ApparentRidge}) {
        LineStyle style = helpers::only(kind);
        style.detail = 100;
        EXPECT_GT(helpers::extract(LineExtractor(mesh, complete), view, style).lines.size(), 0u);
        EXPECT_EQ(helpers::extract(LineExtractor(mesh, alone), view, style).lines.size(), 0u);
    }
    add_curvature_derivatives(mesh, alone);
    EXPECT_TRUE(helpers::same_fields(alone, complete));
}

}  // namespace
