// SPDX-License-Identifier: GPL-3.0-or-later
#include "laplacian_lines/refinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "helpers.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace laplacian_lines;
using test_meshes::moved;
using test_meshes::rounded_to_floats;
using test_meshes::subdivided;

/// How far vertices are off a sphere of radius 1 at most, and middles of sides.
std::pair<double, double> off_sphere(const TriangleMesh& mesh) {
    double vertices = 0, sides = 0;
    for (const Triangle& t : mesh.triangles)
        for (int k = 0; k < 3; ++k) {
            const Eigen::Vector3d &p = mesh.positions[t[k]], &q = mesh.positions[t[(k + 1) % 3]];
            vertices = std::max(vertices, std::abs(p.norm() - 1));
            sides = std::max(sides, std::abs((p + q).norm() / 2 - 1));
        }
    return {vertices, sides};
}

TEST(Refinement, PutsNewVerticesOnTheSmoothSurface) {
    const TriangleMesh mesh = test_meshes::icosphere(3), finer = refined(mesh);
    ASSERT_EQ(finer.triangles.size(), 16 * mesh.triangles.size());
    EXPECT_TRUE(std::equal(mesh.positions.begin(), mesh.positions.end(), finer.positions.begin()));
    EXPECT_LT(off_sphere(finer).first, 0.15 * off_sphere(mesh).second);
    EXPECT_EQ(precompute(finer).report.border_share, 0);
}

TEST(Refinement, IsTheSameFarFromTheOrigin) {
    for (const double scale : {40, 60, 90, 120}) {  // edges of 1.5 to 4.6, floats in steps of .5
        const TriangleMesh mesh = moved(test_meshes::bumpy_sphere(5).mesh, {0, 0, 0}, scale);
        const TriangleMesh far_off = refined(moved(mesh, {4e5, 5.8e6, 30}));
        EXPECT_GT(far_off.triangles.size(), mesh.triangles.size()) << scale;
        EXPECT_EQ(far_off.triangles.size(), refined(mesh).triangles.size()) << scale;
    }
}

TEST(Refinement, LeavesWhatNeedsNone) {
    TriangleMesh broken = test_meshes::icosphere(3);
    const TriangleMesh rounded =
        test_meshes::mapped(broken, [](Eigen::Vector3d& p) { p = (p * 20).array().round(); });
    broken.triangles.back()[0] = 1u << 30;
    // one triangle of two is halved at their common side
    TriangleMesh with_t_junction = test_meshes::cut_apart(test_meshes::icosphere(3));
    const Triangle t = with_t_junction.triangles[0];
    const auto middle = std::uint32_t(with_t_junction.positions.size());
    with_t_junction.positions.push_back(
        (with_t_junction.positions[t[0]] + with_t_junction.positions[t[1]]) / 2);
    with_t_junction.triangles[0] = {t[0], middle, t[2]};
    with_t_junction.triangles.push_back({middle, t[1], t[2]});
    for (const TriangleMesh& mesh :
         {with_t_junction, test_meshes::icosphere(1), test_meshes::icosphere(7),
          test_meshes::cube(20), test_meshes::rounded_cube(20, 0.1), rounded, broken,
          TriangleMesh()})
        EXPECT_TRUE(refined(mesh).positions == mesh.positions &&
                    refined(mesh).triangles == mesh.triangles)
            << mesh.triangles.size();
}

TEST(Refinement, GoesAcrossSeamsHoweverTrianglesAreTurned) {
    const TriangleMesh mesh = test_meshes::bumpy_sphere(4).mesh, finer = refined(mesh);
    ASSERT_EQ(finer.triangles.size(), 16 * mesh.triangles.size());
    const TriangleMesh finer_cut = refined(test_meshes::flipped(test_meshes::cut_apart(mesh), 3));
    ASSERT_EQ(finer_cut.triangles.size(), finer.triangles.size());
    double farthest = 0;
    for (std::size_t t = 0; t < finer.triangles.size(); ++t) {
        const auto middle = [t](const TriangleMesh& of) -> Eigen::Vector3d {
            const Triangle& corners = of.triangles[t];
            return of.positions[corners[0]] + of.positions[corners[1]] + of.positions[corners[2]];
        };
        if (t / 16 % 3 != 0)
            farthest = std::max(farthest, (middle(finer) - middle(finer_cut)).norm());
    }
    EXPECT_LT(farthest, 1e-12);
}

TEST(Refinement, IsThatOfTheMeshBeforeItWasSubdivided) {
    const TriangleMesh mesh = test_meshes::bumpy_sphere(4).mesh, finer = refined(mesh);
    for (const int times : {1, 3}) {
        const TriangleMesh cut = subdivided(mesh, times), again = refined(cut);
        ASSERT_EQ(again.triangles.size(), finer.triangles.size());
        const auto corner = [](const TriangleMesh& of, std::size_t t) -> Eigen::Vector3d {
            return of.positions[of.triangles[t][t % 3]];
        };
        for (std::size_t t = 0; t < finer.triangles.size(); ++t)
            EXPECT_LT((corner(again, t) - corner(finer, t)).norm(), 1e-6);
        EXPECT_NEAR(again.known_edge, finer.known_edge, 1e-6);
        EXPECT_EQ(refined(test_meshes::cut_apart(cut)).triangles.size(), finer.triangles.size());
    }
}

/// Options in mean edges, and the least kernel, are those of the mesh before.
TEST(Refinement, KeepsTheUnitOfOptions) {
    const TriangleMesh mesh = test_meshes::bumpy_sphere(4).mesh;
    const double edge = precompute(mesh).scale.mean_edge;
    PrecomputeOptions options;
    options.normal_sigma = 2;
    const FieldScale scale = precompute(refined(mesh), options).scale;
    EXPECT_NEAR(scale.normal_sigma, 2 * edge, 1e-3 * edge);
    EXPECT_NEAR(scale.kernel_size, 0.6 * edge, 1e-3 * edge);
    EXPECT_LT(scale.mean_edge, 0.3 * edge);
}

TEST(Refinement, LeavesNoiseToBeSmoothed) {
    const TriangleMesh mesh = test_meshes::with_noise(test_meshes::bumpy_sphere(4).mesh, 0.2);
    const Field before = precompute(mesh), after = precompute(refined(mesh));
    ASSERT_LT(after.scale.mean_edge, 0.3 * before.scale.mean_edge);
    ASSERT_GT(before.report.roughness, 0.5);
    EXPECT_DOUBLE_EQ(after.report.roughness, before.report.roughness);
    EXPECT_NEAR(after.scale.normal_sigma, before.scale.normal_sigma,
                1e-3 * before.scale.normal_sigma);
}

TEST(Refinement, StaysFlatAtSharpEdges) {
    // a sphere that stands on a disc
    const TriangleMesh mesh = test_meshes::mapped(
        test_meshes::icosphere(4), [](Eigen::Vector3d& p) { p.z() = std::max(p.z(), -0.5); });
    const TriangleMesh finer = refined(mesh);
    ASSERT_GT(finer.triangles.size(), mesh.triangles.size());
    for (const Eigen::Vector3d& p : finer.positions)
        EXPECT_GE(p.z(), -0.506) << "a twelfth of an edge";
}

/// What decimation leaves has the lines of the whole.
TEST(Refinement, GivesCoarseMeshesTheLinesOfFineOnes) {
    const TriangleMesh coarse = test_meshes::bumpy_sphere(3).mesh;
    const View view = View::orthographic({0.3, -0.5, 0.8});
    const auto lines_of = [&](const TriangleMesh& mesh) {
        PrecomputeOptions options;
        options.kernel_size = 0.1;
        return helpers::extract(LineExtractor(mesh, precompute(mesh, options)), view,
                                helpers::only(LineKind::Laplacian));
    };
    const LineSet truth = lines_of(test_meshes::bumpy_sphere(6).mesh);
    const auto found = [&](const LineSet& lines) {  // the share of the true lines
        std::size_t near = 0;
        for (const LinePoint& p : truth.points)
            near += helpers::distance_to_lines(p.position.cast<double>(), lines) < 0.02;
        return double(near) / double(truth.points.size());
    };
    ASSERT_GT(truth.points.size(), 100u);
    EXPECT_GT(found(lines_of(refined(coarse))), 0.95);
    EXPECT_LT(found(lines_of(coarse)), 0.9);
}

TEST(Normals, OfAMeshAreTaken) {
    TriangleMesh mesh = test_meshes::sphere(3).mesh;
    PrecomputeOptions options;
    options.normal_smoothing = NormalSmoothing::None;
    mesh.normals.assign(mesh.positions.size(), Eigen::Vector3d::Zero());
    mesh.normals[7] = (mesh.positions[7] + Eigen::Vector3d(0.1, 0.2, 0.3)).normalized();
    const Field field = precompute(mesh, options);
    EXPECT_LT((field.normals[7].cast<double>() - mesh.normals[7]).norm(), 1e-6);
    EXPECT_LT((field.normals[8].cast<double>() - mesh.positions[8]).norm(), 0.01) << "0: its own";
    mesh.normals.pop_back();
    EXPECT_THROW(precompute(mesh, options), Error);
}

TriangleMesh scan() {
    return test_meshes::with_noise(test_meshes::bumpy_sphere(4).mesh, 0.1);
}

/// Vertices, triangles and their corners in another order.
TriangleMesh shuffled(const TriangleMesh& mesh) {
    std::mt19937 random(7);
    std::vector<std::uint32_t> place(mesh.positions.size());
    std::iota(place.begin(), place.end(), 0);
    std::shuffle(place.begin(), place.end(), random);
    TriangleMesh result = mesh;
    for (std::size_t v = 0; v < place.size(); ++v)
        result.positions[place[v]] = mesh.positions[v];
    for (Triangle& t : result.triangles) {
        for (std::uint32_t& v : t)
            v = place[v];
        std::rotate(t.begin(), t.begin() + random() % 3, t.end());
    }
    std::shuffle(result.triangles.begin(), result.triangles.end(), random);
    return result;
}

TEST(Subdivisions, AreUndone) {
    for (const TriangleMesh& mesh :
         {test_meshes::together(scan(), moved(scan(), {3, 0, 0})), test_meshes::flipped(scan(), 5),
          moved(scan(), {20, -30, 0}),
          test_meshes::with_noise(test_meshes::half_torus(60, 40).mesh, 0.1)})
        for (const int times : {1, 2}) {
            const TriangleMesh cut = rounded_to_floats(subdivided(rounded_to_floats(mesh), times));
            const TriangleMesh undone = refined(cut), expected = refined(rounded_to_floats(mesh));
            const std::size_t count = expected.triangles.size();
            ASSERT_EQ(undone.triangles.size(), count);
            for (std::size_t t = 0; t < count; ++t)
                for (std::size_t k = 0; k < 3; ++k)
                    EXPECT_LT((undone.positions[undone.triangles[t][k]] -
                               expected.positions[expected.triangles[t][k]])
                                  .norm(),
                              1e-9);
            EXPECT_EQ(refined(shuffled(cut)).triangles.size(), count);
            EXPECT_EQ(refined(test_meshes::cut_apart(cut)).triangles.size(), count);
        }
}

TEST(Subdivisions, StayWhereNotAllTrianglesAreQuarters) {
    const TriangleMesh cut = subdivided(scan());
    TriangleMesh bent = cut, open = cut, doubled = cut;
    bent.positions.back() += 1e-3 * Eigen::Vector3d::Ones();
    open.triangles.resize(open.triangles.size() - 5);
    doubled.triangles.insert(doubled.triangles.end(), cut.triangles.end() - 4, cut.triangles.end());
    const TriangleMesh other = test_meshes::together(cut, test_meshes::icosphere(2));
    for (const TriangleMesh& mesh : {bent, open, doubled, other})
        EXPECT_EQ(refined(mesh).triangles, mesh.triangles);
}

/// Until edges are shorter than 2.5 % of D; cuts beyond are undone.
TEST(Subdivisions, StayOnFormsOfFewLargeTriangles) {
    const TriangleMesh form = test_meshes::icosphere(0);
    for (const int times : {3, 4, 5, 6})
        EXPECT_EQ(refined(subdivided(form, times)).triangles.size(),
                  subdivided(form, std::min(times, 4)).triangles.size());
}

/// Each second vertex of a smooth grid is nearly the middle of its neighbours.
TEST(Subdivisions, AreNotSeenInGridsFarFromTheOrigin) {
    const TriangleMesh terrain = test_meshes::mapped(
        test_meshes::hills(128).mesh,
        [](Eigen::Vector3d& p) { p = Eigen::Vector3d(64, 64, 6.4).cwiseProduct(p); });
    for (const Eigen::Vector3d& corner : {Eigen::Vector3d(4e5, 5.8e6, 30), {4e6, 8e5, 4.9e6}})
        EXPECT_GE(refined(moved(terrain, corner)).triangles.size(), terrain.triangles.size());
}

}  // namespace
