// SPDX-License-Identifier: GPL-3.0-or-later
// C and S̄, the smoothed curvatures that come with it, against smooth surfaces and noise.
#include <gtest/gtest.h>

#include <cmath>

#include "helpers.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/precompute.h"
#include "mesh_noise.h"

namespace {

using namespace laplacian_lines;
using test_meshes::AnalyticMesh;

Field compute(const TriangleMesh& mesh) {
    PrecomputeOptions options;
    options.curvature_derivatives = true;
    return precompute(mesh, options);
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
        double curvatures, derivatives,
            ratio;  // errors of the coarse one; of C, the fine one's share
    } families[] = {
        {"torus", [](int l) { return test_meshes::torus(80 << l, 40 << l); }, 0.07, 0.23, 0.35},
        {"torus, jitter .25", [](int l) { return test_meshes::torus(80 << l, 40 << l, 0.25); },
         0.07, 0.24, 0.4},
        {"ellipsoid", [](int l) { return test_meshes::ellipsoid(5 + l); }, 0.06, 0.19, 0.4},
        {"bumpy sphere, jitter .15", [](int l) { return test_meshes::bumpy_sphere(5 + l, 0.15); },
         0.08, 0.28, 0.4},
    };
    for (const auto& family : families) {
        double curvatures[2], derivatives[2];
        for (const int level : {0, 1}) {
            const AnalyticMesh surface = family.make(level);
            const Field field = compute(surface.mesh);
            curvatures[level] = smooth_error(surface, field);
            derivatives[level] = helpers::derivative_error(field, surface.truth);
        }
        EXPECT_LT(curvatures[0], family.curvatures) << family.name;
        EXPECT_LT(curvatures[1], 0.4 * curvatures[0]) << family.name;
        EXPECT_LT(derivatives[0], family.derivatives) << family.name;
        EXPECT_LT(derivatives[1], family.ratio * derivatives[0]) << family.name;
    }
}

TEST(SmoothCurvatures, AreThoseOfSpheres) {
    const double radius = 5;
    const Field field = compute(test_meshes::sphere(5, radius).mesh);
    for (const Eigen::Vector3f& s : field.smooth_curvatures) {
        EXPECT_NEAR(s[0] * radius, 1, 0.02);
        EXPECT_NEAR(s[1] * radius, 0, 0.02);
        EXPECT_NEAR(s[2] * radius, 1, 0.02);
    }
}

TEST(SmoothCurvatures, HaveLessNoiseThanTheOthers) {
    AnalyticMesh surface = test_meshes::sphere(6, 1);
    surface.mesh = mesh_noise::with_noise(surface.mesh, 0.2);
    const Field field = compute(surface.mesh);
    EXPECT_LT(smooth_error(surface, field), 0.85 * raw_error(surface, field));
}

/// Older versions stored C alone.
TEST(SmoothCurvatures, AreAddedToFieldsThatHaveDerivativesAlone) {
    const TriangleMesh& mesh = test_meshes::mesh_named("bumpy_sphere").mesh;
    const Field complete = compute(mesh);
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
