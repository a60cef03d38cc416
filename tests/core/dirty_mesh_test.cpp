// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices that are not numbers and triangles without area are left out, counted, and change
// nothing else.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "flaked_stone.h"
#include "helpers.h"
#include "laplacian_lines/mesh_faults.h"
#include "laplacian_lines/precompute.h"
#include "mesh_file.h"
#include "mesh_noise.h"
#include "places.h"

namespace {

using namespace laplacian_lines;

struct DirtyTorus {
    TriangleMesh clean = test_meshes::torus(40, 20, 0.2).mesh;
    std::vector<std::uint32_t> clean_vertex;
    TriangleMesh dirty = test_meshes::with_dirt(clean, clean_vertex);
};

TEST(DirtyMesh, PartsLeftOutAreCounted) {
    const DirtyTorus torus;
    const MeshReport report = precompute(torus.dirty).report;
    EXPECT_EQ(report.vertices, torus.clean.positions.size() + 5);
    EXPECT_EQ(report.triangles, torus.clean.triangles.size() + 5);
    EXPECT_EQ(report.non_finite_vertices, 3u);
    EXPECT_EQ(report.unreferenced_vertices, 2u);
    EXPECT_EQ(report.degenerate_triangles, 5u);
}

TEST(DirtyMesh, CleanMeshesHaveNothingLeftOut) {
    for (const test_meshes::MeshEntry& entry : test_meshes::all_entries()) {
        const test_meshes::TestMesh& mesh = entry.get();
        if (mesh.has(test_meshes::kDirty)) continue;
        const MeshReport report = precompute(mesh.mesh).report;
        EXPECT_EQ(report.vertices, mesh.mesh.positions.size()) << mesh;
        EXPECT_EQ(report.triangles, mesh.mesh.triangles.size()) << mesh;
        EXPECT_EQ(
            report.non_finite_vertices + report.unreferenced_vertices + report.degenerate_triangles,
            0u)
            << mesh;
    }
}

TEST(DirtyMesh, TheRestIsAsWithoutTheDirt) {
    const DirtyTorus torus;
    const Field clean = precompute(torus.clean), dirty = precompute(torus.dirty);
    EXPECT_DOUBLE_EQ(clean.scale.diagonal, dirty.scale.diagonal);
    EXPECT_DOUBLE_EQ(clean.scale.mean_edge, dirty.scale.mean_edge);
    for (std::size_t v = 0; v < torus.clean.positions.size(); ++v) {
        const std::uint32_t d = torus.clean_vertex[v];
        const float size = clean.laplacian_normals[v].norm();
        EXPECT_LT((clean.laplacian_normals[v] - dirty.laplacian_normals[d]).norm(), 1e-5 * size);
        EXPECT_LT((clean.normals[v] - dirty.normals[d]).norm(), 1e-6);
        EXPECT_LT(
            (helpers::matrix(clean.shape_operators[v]) - helpers::matrix(dirty.shape_operators[d]))
                .norm(),
            1e-5);
    }
}

TEST(DirtyMesh, LinesAreAsWithoutTheDirt) {
    const DirtyTorus torus;
    const LineExtractor clean(torus.clean, precompute(torus.clean));
    const LineExtractor dirty(torus.dirty, precompute(torus.dirty));
    const View view = View::perspective({2, -3, 2});
    const LineSet a = helpers::extract(clean, view, helpers::all_crossings());
    const LineSet b = helpers::extract(dirty, view, helpers::all_crossings());
    EXPECT_EQ(a.lines.size(), b.lines.size());
    EXPECT_EQ(a.points.size(), b.points.size());
    for (const LinePoint& p : a.points)
        EXPECT_LT(helpers::distance_to_lines(p.position.cast<double>(), b), 1e-4);
}

class FiniteFields : public testing::TestWithParam<const test_meshes::MeshEntry*> {};

TEST_P(FiniteFields, WithAnyOptions) {
    for (int i = 0; i < 48; ++i) {
        PrecomputeOptions options;
        options.laplace_operator = LaplaceOperator(i % 2);
        options.normal_weighting = NormalWeighting(i / 2 % 3);
        options.normal_smoothing = NormalSmoothing(i % 3);
        options.gradient_estimator = GradientEstimator(i / 3 % 2);
        options.kernel_mode = KernelMode(i / 4 % 2);
        options.correct_borders = i / 8 % 2;
        options.skip_opposite_sheet = i / 16 % 2;
        options.accuracy = 0.01;
        const Field field = precompute(GetParam()->get().mesh, options);
        for (std::size_t v = 0; v < field.normals.size(); ++v) {
            ASSERT_TRUE(field.normals[v].allFinite()) << v;
            ASSERT_TRUE(field.laplacian_normals[v].allFinite()) << v;
            ASSERT_TRUE(helpers::matrix(field.shape_operators[v]).allFinite()) << v;
            ASSERT_TRUE(std::isfinite(field.kernel_sizes[v])) << v;
            ASSERT_TRUE(field.normals[v].isZero() || std::abs(field.normals[v].norm() - 1) < 1e-5)
                << v;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Meshes, FiniteFields, testing::ValuesIn(test_meshes::meshes_with(0)),
                         [](const auto& info) { return info.param->name; });

/// Kernels that reach no neighbour, and all vertices.
TEST(ExtremeKernels, StayFinite) {
    for (const char* name : {"torus", "hills", "scattered_spheres"})
        for (double size : {1e-300, 1e-9, 1e-4, 10.0, 1e6, 1e300}) {
            PrecomputeOptions options;
            options.kernel_size = size;
            for (const Eigen::Vector3f& x :
                 precompute(test_meshes::mesh_named(name).mesh, options).laplacian_normals)
                ASSERT_TRUE(x.allFinite()) << name << ", kernel size " << size;
        }
}

/// Faces that cancel each other, needles, and lengths near the ends of the number range.
TEST(ExtremeMeshes, StayFinite) {
    TriangleMesh doubled = test_meshes::mesh_named("plane").mesh;
    const std::vector<Triangle> front = doubled.triangles;
    for (const Triangle& t : front)
        doubled.triangles.push_back({t[0], t[2], t[1]});
    TriangleMesh needles = test_meshes::mesh_named("torus_jittered").mesh;
    for (Eigen::Vector3d& p : needles.positions)
        p.x() *= 1e-9;
    TriangleMesh huge = test_meshes::mesh_named("torus").mesh, tiny = huge;
    for (Eigen::Vector3d& p : huge.positions)
        p *= 1e14;
    for (Eigen::Vector3d& p : tiny.positions)
        p *= 1e-15;
    for (const TriangleMesh& mesh : {doubled, needles, huge, tiny}) {
        const Field field = precompute(mesh);
        for (const Eigen::Vector3f& x : field.laplacian_normals)
            ASSERT_TRUE(x.allFinite());
        const Eigen::Vector3d eye = field.scale.diagonal * Eigen::Vector3d(1, 2, 1.5);
        for (const LinePoint& p : helpers::extract(LineExtractor(mesh, field),
                                                   View::perspective(eye), helpers::all_crossings())
                                      .points)
            ASSERT_TRUE(p.position.allFinite() && std::isfinite(p.gradient));
    }
}

// ---- scanned models that can be had here, and one that always can ----

class RealModel : public testing::TestWithParam<const char*> {};

TriangleMesh noisy_stone() {
    return mesh_noise::with_noise(test_meshes::FlakedStone({}).mesh(6), 0.2);
}

TEST_P(RealModel, IsDrawnWithSomeOfItsZeroCrossings) {
    const bool is_made = std::string(GetParam()) == "stone";
    const std::string path = places::scanned_model(GetParam()).string();
    if (!is_made && path.empty())
        GTEST_SKIP() << GetParam() << " neither lies beside the repository nor was it fetched";
    const TriangleMesh mesh = is_made ? noisy_stone() : test_meshes::read_mesh(path);
    const Field field = precompute(mesh);
    EXPECT_TRUE(faults_of(field.report).empty());
    const LineExtractor extractor(mesh, field);
    for (const View& view : helpers::random_views(mesh, 4)) {
        const LineSet lines = helpers::extract(extractor, view, {});
        const LineSet unfiltered = helpers::extract(extractor, view, helpers::all_crossings());
        EXPECT_GT(lines.lines.size(), 10u);
        EXPECT_LT(lines.lines.size(), 1000u);
        EXPECT_LT(helpers::total_length(lines), 0.75 * helpers::total_length(unfiltered));
    }
}

INSTANTIATE_TEST_SUITE_P(Models, RealModel,
                         testing::Values("bunny", "igea", "armadillo", "dragon_res2", "stone"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
