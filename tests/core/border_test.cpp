// SPDX-License-Identifier: GPL-3.0-or-later
// Where the kernel is not a full disc of one surface: borders and thin walls.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "helpers.h"
#include "laplacian_lines/precompute.h"
#include "reference_field.h"

namespace {

using namespace laplacian_lines;

/// Vertices of a half torus (0 <= u <= π) with less than `reach` along the ring to a border.
std::vector<bool> near_border(const TriangleMesh& half_torus, double reach) {
    std::vector<bool> near;
    for (const Eigen::Vector3d& p : half_torus.positions)
        near.push_back(p.y() < reach);
    return near;
}

double border_error(const test_meshes::AnalyticMesh& surface, bool correct, double reach) {
    PrecomputeOptions options;
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

TEST(Borders, CorrectionHelpsMoreOnFinerMeshes) {
    const auto improvement = [](int cells) {
        const auto surface = test_meshes::half_torus(cells, cells);
        const double reach = 4 * reference::mean_edge(surface.mesh);
        return border_error(surface, false, reach) / border_error(surface, true, reach);
    };
    const double coarse = improvement(40), fine = improvement(120);
    EXPECT_GT(fine, coarse);
    EXPECT_GT(fine, 3);
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

/// A kernel much larger than the surface finds hardly any mass; full compensation would be
/// meaningless.
TEST(Borders, CorrectionMakesUpForNoMoreThanFourFifths) {
    const test_meshes::TestMesh& hills = test_meshes::mesh_named("hills");
    PrecomputeOptions options;
    options.kernel_size = 3;
    const Field corrected = precompute(hills.mesh, options);
    options.correct_borders = false;
    const Field plain = precompute(hills.mesh, options);
    for (std::size_t v = 0; v < hills.mesh.positions.size(); ++v) {
        const double expected = 5 * plain.laplacian_normals[v].dot(plain.normals[v]);
        EXPECT_NEAR(corrected.laplacian_normals[v].dot(plain.normals[v]), expected,
                    1e-4 * std::abs(expected) + 1e-6);
    }
}

/// Between a square and its parallel at distance d, facing away, Eq. 2 puts 2 exp(−d²/4h)/h.
TEST(ThinWalls, SpuriousTermIsAsPredictedWithoutSkipping) {
    const double d = 0.1, size = 0.1;
    const TriangleMesh mesh = test_meshes::parallel_sheets(40, d);
    const Field field = precompute(mesh, helpers::plain_options(size));
    const double predicted = 2 * std::exp(-d * d / (4 * size * size)) / (size * size);
    int inner = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        if (mesh.positions[v].head<2>().cwiseAbs().maxCoeff() > 0.3) continue;
        ++inner;
        EXPECT_NEAR(field.laplacian_normals[v].dot(field.normals[v]), -predicted, 0.01 * predicted);
    }
    EXPECT_GT(inner, 100);
}

TEST(ThinWalls, SkippingTheOppositeSheetRemovesIt) {
    PrecomputeOptions options = helpers::plain_options(0.1);
    options.skip_opposite_sheet = true;
    const Field field = precompute(test_meshes::parallel_sheets(40, 0.1), options);
    float largest = 0;
    for (const Eigen::Vector3f& x : field.laplacian_normals)
        largest = std::max(largest, x.norm());
    EXPECT_LT(largest, 1e-3);  // 156 without skipping
}

TEST(ThinWalls, SmoothingTakesNoNormalsFromTheOppositeSheet) {
    PrecomputeOptions options;
    options.normal_sigma = 3;
    const TriangleMesh mesh = test_meshes::parallel_sheets(40, 0.01);
    const Field field = precompute(mesh, options);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        EXPECT_LT((field.normals[v] - Eigen::Vector3f(0, 0, mesh.positions[v].z() > 0 ? 1.f : -1.f))
                      .norm(),
                  1e-6);
}

/// The two sides of a shell: spheres of radius 1 facing out and 0.97 facing in.
TEST(ThinWalls, LeastSquaresTakeNoNormalsFromTheOppositeSheet) {
    const test_meshes::AnalyticMesh outer = test_meshes::sphere(4);
    TriangleMesh shell = outer.mesh;
    test_meshes::append(shell,
                        test_meshes::moved(test_meshes::inside_out(outer.mesh), {0, 0, 0}, 0.97));
    PrecomputeOptions options;
    options.gradient_estimator = GradientEstimator::LeastSquares;
    EXPECT_LT(helpers::shape_error(precompute(shell, options), outer.truth), 0.02);
    options.skip_opposite_sheet = false;
    EXPECT_GT(helpers::shape_error(precompute(shell, options), outer.truth), 0.2);
}

}  // namespace
