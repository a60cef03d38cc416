// SPDX-License-Identifier: GPL-3.0-or-later
// How rough a surface is, and the smoothing that follows from it.
#include <gtest/gtest.h>

#include <cmath>

#include "closed_mesh.h"
#include "field/field_steps.h"
#include "flaked_stone.h"
#include "helpers.h"
#include "implicit_head.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/precompute.h"
#include "mesh_noise.h"

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

/// All kinds, from the front, in D.
double drawn_length(const TriangleMesh& mesh, const PrecomputeOptions& options) {
    const Field field = precompute(mesh, options);
    const double d = field.scale.diagonal;
    const LineSet lines = helpers::extract(LineExtractor(mesh, field),
                                           View::perspective(d * Vector3d(0.5, 0.3, 1.4)), {});
    double length = 0;
    for (const Polyline& line : lines.lines)
        for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i)
            length += double((lines.points[i].position - lines.points[i - 1].position).norm()) / d;
    return length;
}

TEST(MarchingCubes, MakesClosedSpheresThatFaceOutwards) {
    const auto ball = [](const Vector3d& p) { return p.norm() - 0.7; };
    const test_meshes::Volume volume = test_meshes::sampled(ball, 40, 1);
    const double exact = 4 / 3. * std::acos(-1.) * std::pow(0.7, 3), voxel = 2 / 39.;
    for (const bool labels : {false, true}) {
        const TriangleMesh mesh =
            test_meshes::marching_cubes(labels ? test_meshes::labels_of(volume) : volume);
        EXPECT_EQ(helpers::edges_without_partner(mesh), 0u);
        EXPECT_NEAR(helpers::volume(mesh), exact, 0.02 * exact);
        for (const Vector3d& p : mesh.positions)
            ASSERT_NEAR(ball(p), 0, labels ? voxel / 2 : voxel * voxel);
    }
}

TEST(Roughness, OfSmoothAndCoarseMeshesChangesNothing) {
    for (const test_meshes::MeshEntry& entry : test_meshes::all_entries())
        if (!entry.has(test_meshes::kUnusable)) {
            const Field field = precompute(entry.get().mesh);
            EXPECT_NEAR(sigma_of(field), 0.8, 1e-9) << entry.name;
            EXPECT_LT(field.report.roughness, 0.2) << entry.name;
        }
    EXPECT_NEAR(sigma_of(test_meshes::smooth_head(kVoxels)), 0.8, 1e-9);
    EXPECT_EQ(precompute(test_meshes::sphere(5).mesh).report.roughness, 0);
}

TEST(Roughness, TellsTerracesAndNoiseOnSmoothForms) {
    const Field rough = precompute(terraces());
    EXPECT_GT(rough.report.roughness, 1.6);
    EXPECT_GT(sigma_of(rough), 1.2);
    EXPECT_LT(sigma_of(rough), 1.7);
    EXPECT_GT(sigma_of(test_meshes::terraced_head(100)), sigma_of(rough))
        << "more voxels: the same terraces on a form that is smoother at their scale";
    EXPECT_GT(sigma_of(mesh_noise::with_noise(test_meshes::sphere(5).mesh, 0.4)), 1.6);
}

/// Where the scales say too little: fine forms, large triangles.
TEST(Roughness, TellsNoiseOnCoarseMeshes) {
    const auto roughness = [](const TriangleMesh& mesh) {
        return precompute(mesh).report.roughness;
    };
    TriangleMesh bumps = test_meshes::bumpy_sphere(4).mesh;
    TriangleMesh cylinder = test_meshes::cylinder(48, 24).mesh;
    TriangleMesh sheets = test_meshes::parallel_sheets(24, 0.05);
    for (const double noise : {0.1, 0.2, 0.4})
        for (TriangleMesh* mesh : {&bumps, &cylinder, &sheets})
            EXPECT_EQ(roughness(mesh_noise::with_noise(*mesh, noise)), 1);
}

TEST(Roughness, OfFacetsDoesNotMindOrientation) {
    const auto is_noisy = [](const TriangleMesh& mesh) {
        PreparedMesh prepared = prepare_mesh(mesh, Cuts::Left);
        sort_in_space(prepared);
        return has_noisy_facets(prepared);
    };
    TriangleMesh bumps = test_meshes::bumpy_sphere(4).mesh;
    test_meshes::flip_triangles(bumps, 3);
    EXPECT_FALSE(is_noisy(bumps));
    EXPECT_TRUE(is_noisy(mesh_noise::with_noise(bumps, 0.2)));
}

/// As rough as noise, but not everywhere.
TEST(Roughness, IsNotThatOfCoarseForms) {
    for (const int level : {3, 4}) {
        const TriangleMesh stone = test_meshes::FlakedStone({1, 0.01, 40, 5}).mesh(level);
        EXPECT_LT(precompute(stone).report.roughness, 0.5) << level;
    }
    for (const int size : {25, 30, 40})
        EXPECT_LT(precompute(test_meshes::smooth_head(size)).report.roughness, 0.5) << size;
}

/// Edges turned by noise are not the form's.
TEST(Roughness, HasNoisyCoarseMeshesDrawnWithSmoothContours) {
    const TriangleMesh bumps = test_meshes::bumpy_sphere(4).mesh;
    const double clean = drawn_length(bumps, {});
    EXPECT_NEAR(drawn_length(mesh_noise::with_noise(bumps, 0.1), {}), clean, 0.2 * clean);
    EXPECT_NEAR(drawn_length(mesh_noise::with_noise(bumps, 0.2), {}), clean, 0.5 * clean);
}

TEST(Roughness, HasTheSmoothingInProportionWithinLimits) {
    EXPECT_EQ(automatic_normal_sigma(0), 0.8);
    EXPECT_EQ(automatic_normal_sigma(1.1), 0.8);
    EXPECT_NEAR(automatic_normal_sigma(2), 1.4, 1e-12);
    EXPECT_EQ(automatic_normal_sigma(100), 2.5);
}

TEST(Roughness, DoesNotDependOnSizeAndPlace) {
    TriangleMesh moved = terraces();
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    for (Vector3d& p : moved.positions)
        p = 250 * (turn * p) + Vector3d(10, 20, 30);
    // Vertices are sampled along the axes.
    EXPECT_NEAR(precompute(moved).report.roughness, precompute(terraces()).report.roughness, 0.2);
}

TEST(Roughness, IsOverriddenByASigmaAndByNoSmoothing) {
    PrecomputeOptions options;
    for (const double sigma : {0.3, 0.8, 3.}) {
        options.normal_sigma = sigma;
        const Field field = precompute(terraces(), options);
        EXPECT_NEAR(sigma_of(field), sigma, 1e-9);
        EXPECT_GT(field.report.roughness, 1.5) << "whether or not it decides";
        EXPECT_DOUBLE_EQ(measure_scale(terraces(), options).normal_sigma, field.scale.normal_sigma);
    }
    options.normal_sigma = 0;
    options.normal_smoothing = NormalSmoothing::None;
    EXPECT_EQ(precompute(terraces(), options).scale.normal_sigma, 0);
}

TEST(Roughness, GivesTheFieldOfTheSigmaThatItChooses) {
    const Field field = precompute(terraces());
    PrecomputeOptions options;
    options.normal_sigma = automatic_normal_sigma(field.report.roughness);
    EXPECT_TRUE(helpers::same_fields(field, precompute(terraces(), options)));
}

TEST(Roughness, HasTerracesDrawnWithAsManyLinesAsTheSmoothForm) {
    PrecomputeOptions little;
    little.normal_sigma = 0.8;
    const double smooth = drawn_length(test_meshes::smooth_head(80), {});
    const TriangleMesh terraced = test_meshes::terraced_head(80);
    EXPECT_NEAR(drawn_length(terraced, {}), smooth, 0.2 * smooth);
    EXPECT_GT(drawn_length(terraced, little), 1.2 * smooth);
}

}  // namespace
