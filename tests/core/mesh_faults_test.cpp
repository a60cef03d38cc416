// SPDX-License-Identifier: GPL-3.0-or-later
// Fields do not depend on which way round a file has its triangles; what is said about meshes that
// draw badly, and nothing about others.
#include <gtest/gtest.h>

#include <map>

#include "helpers.h"
#include "laplacian_lines/line_mixture.h"
#include "laplacian_lines/mesh_faults.h"
#include "laplacian_lines/precompute.h"
#include "registry.h"

namespace {

using namespace laplacian_lines;
using namespace test_meshes;
using Faults = std::vector<MeshFault>;

/// Of the way round, 1 outwards: the mean of the normals along the vertices from a centre.
double facing(const Field& field, const TriangleMesh& mesh, const Eigen::Vector3d& centre,
              double least, double most) {
    double sum = 0, count = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const Eigen::Vector3d from = mesh.positions[v] - centre;
        if (from.norm() < least || from.norm() > most) continue;
        sum += field.normals[v].cast<double>().dot(from.normalized());
        ++count;
    }
    return sum / count;
}

void expect_same_bits(const TriangleMesh& mesh, const TriangleMesh& other) {
    const Field field = precompute(mesh), turned = precompute(other);
    EXPECT_EQ(field.normals, turned.normals);
    EXPECT_EQ(field.laplacian_normals, turned.laplacian_normals);
    const View view = View::orthographic({1, 2, 3});
    const LineSet lines = helpers::extract(LineExtractor(mesh, field), view, {}),
                  others = helpers::extract(LineExtractor(other, turned), view, {});
    EXPECT_FALSE(lines.lines.empty());
    EXPECT_TRUE(helpers::same_lines(lines, others));
}

TEST(Orientation, ClosedBodiesAreReadTheRightWayRound) {
    for (const char* name : {"torus", "rounded_cube"})
        for (const int every : {1, 3}) {
            const TriangleMesh turned = flipped(mesh_named(name).mesh, every);
            expect_same_bits(mesh_named(name).mesh, turned);
            EXPECT_EQ(precompute(turned).report.flipped_triangles,
                      every == 1 ? turned.triangles.size() : (turned.triangles.size() + 2) / 3);
        }
}

TEST(Orientation, CutsThatDisagreeAreClosed) {
    const TriangleMesh soup = cut_apart(mesh_named("torus").mesh);
    EXPECT_EQ(precompute(flipped(soup, 3)).normals, precompute(soup).normals);
}

/// A shell with a ball in its cavity.
TEST(Orientation, CavitiesStay) {
    const auto ball = [](double radius) { return moved(icosphere(3), {1, 2, 3}, radius); };
    TriangleMesh mesh = together(together(flipped(ball(0.8)), ball(1)), ball(0.4));
    for (const bool is_inverted : {false, true}) {
        if (is_inverted) mesh = flipped(mesh);
        const Field field = precompute(mesh);
        EXPECT_EQ(field.report.flipped_triangles, is_inverted ? mesh.triangles.size() : 0);
        EXPECT_GT(facing(field, mesh, {1, 2, 3}, 0.9, 1.1), 0.99);
        EXPECT_LT(facing(field, mesh, {1, 2, 3}, 0.7, 0.9), -0.99);
        EXPECT_GT(facing(field, mesh, {1, 2, 3}, 0, 0.5), 0.99);
    }
    const TriangleMesh beside = together(flipped(moved(icosphere(3), {4, 2, 3})), mesh);
    EXPECT_GT(facing(precompute(beside), beside, {4, 2, 3}, 0, 1.1), 0.99);
}

TEST(Orientation, IsThatOfMostTriangles) {
    const TriangleMesh cavity = flipped(icosphere(2)),
                       mesh = together(cavity, moved(icosphere(2), {0, 0, 0}, 2));
    for (const std::size_t first : {std::size_t(0), cavity.triangles.size()}) {
        TriangleMesh other = mesh;
        std::swap(other.triangles[first][1], other.triangles[first][2]);
        const Field field = precompute(other);
        EXPECT_EQ(field.report.flipped_triangles, 1u);
        EXPECT_LT(facing(field, other, {0, 0, 0}, 0, 1.5), -0.99);
        EXPECT_GT(facing(field, other, {0, 0, 0}, 1.5, 3), 0.99);
    }
}

/// Two cubes with as many vertices in common as are at one place.
TriangleMesh touching_cubes(const Eigen::Vector3d& by, double size) {
    TriangleMesh mesh = together(cube(1), flipped(moved(cube(1), by, size)));
    for (Triangle& t : mesh.triangles)
        for (std::uint32_t& v : t)
            for (std::uint32_t other = 0; other < 8; ++other)
                if (mesh.positions[v] == mesh.positions[other]) v = other;
    return mesh;
}

TEST(Orientation, BodiesThatTouchAreBodiesOfTheirOwn) {
    for (const TriangleMesh& mesh :
         {touching_cubes({1.5, 1.5, 1.5}, 0.5), touching_cubes({2, 2, 0}, 1)})
        EXPECT_EQ(precompute(mesh).report.flipped_triangles, 12u);
}

TEST(Orientation, OpenSurfacesKeepTheSideOfMostOfTheirArea) {
    const TriangleMesh& hills = mesh_named("hills").mesh;
    EXPECT_EQ(precompute(flipped(hills, 3)).normals, precompute(hills).normals);
    EXPECT_EQ(precompute(flipped(hills)).report.flipped_triangles, 0u);
}

/// The needle along a square's diagonal folds back, by a hundred-thousandth of it.
TEST(Orientation, FoldedNeedlesTurnTheirBackForNoForm) {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {100, 0, 0}, {100, 100, 0}, {0, 100, 0}, {50.001, 49.999, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 4}, {0, 4, 3}, {4, 2, 3}};
    const Field field = precompute(mesh);
    LineStyle style;
    style.shows = only_kinds({LineKind::Contour, LineKind::Crease});
    const LineExtractor extractor(mesh, field);
    for (const Eigen::Vector3d& eye : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(1, 2, 3)})
        EXPECT_TRUE(helpers::extract(extractor, View::orthographic(eye), style).lines.empty());
}

Faults faults_found(const TriangleMesh& mesh, const PrecomputeOptions& options = {}) {
    return faults_of(precompute(mesh, options).report);
}

/// Separate triangles, slightly shrunk.
TriangleMesh shrunk_triangles(const TriangleMesh& whole, double share) {
    TriangleMesh mesh = cut_apart(whole);
    for (const Triangle& t : mesh.triangles) {
        const Eigen::Vector3d centre =
            (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3;
        for (std::uint32_t v : t)
            mesh.positions[v] += share * (centre - mesh.positions[v]);
    }
    return mesh;
}

/// By design; all others are sound.
TEST(MeshFaults, AreThoseThatTestMeshesAreMadeWith) {
    std::map<std::string, Faults> faulty = {{"flipped_torus", {MeshFault::Flipped}},
                                            {"triangle_soup", {MeshFault::Torn}}};
    for (const std::string& name : mesh_names())
        EXPECT_EQ(faults_found(mesh_named(name).mesh), faulty[name]) << name;
}

TEST(MeshFaults, OfSurfacesTurnedInsideOut) {
    for (const char* name : {"sphere", "torus", "bumpy_sphere", "ellipsoid", "rounded_cube"}) {
        const TriangleMesh& mesh = mesh_named(name).mesh;
        EXPECT_EQ(faults_found(flipped(mesh)), Faults{MeshFault::InsideOut}) << name;
    }
    // Triangles without area face nowhere.
    TriangleMesh degenerate = flipped(mesh_named("sphere").mesh);
    degenerate.triangles.resize(degenerate.triangles.size() * 5 / 4, {0, 0, 0});
    EXPECT_EQ(faults_found(degenerate), Faults{MeshFault::InsideOut});
    // A hole, as in scans; an open surface has no inside.
    TriangleMesh holed = mesh_named("sphere").mesh;
    holed.triangles.resize(holed.triangles.size() * 98 / 100);
    EXPECT_EQ(faults_found(holed), Faults());
    EXPECT_EQ(faults_found(flipped(holed)), Faults{MeshFault::InsideOut});
    for (const char* name : {"hills", "plane", "half_torus"})
        EXPECT_EQ(faults_found(flipped(mesh_named(name).mesh)), Faults()) << name;
}

TEST(MeshFaults, OfTrianglesTurnedHereAndThere) {
    for (const char* name : {"sphere", "hills"})
        for (int every : {2, 3, 20})
            EXPECT_EQ(faults_found(flipped(mesh_named(name).mesh, every)),
                      Faults{MeshFault::Flipped})
                << name << every;
    // Only the few edges of a seam disagree.
    EXPECT_EQ(faults_found(test_meshes::moebius_strip(60, 8)), Faults());
    EXPECT_EQ(faults_found(flipped(test_meshes::moebius_strip(60, 8), 3)),
              Faults{MeshFault::Disagreeing});
}

TEST(MeshFaults, OfPiecesThatDoNotHangTogether) {
    const TriangleMesh& torus = mesh_named("torus").mesh;
    EXPECT_EQ(faults_found(shrunk_triangles(torus, 0.01)), Faults{MeshFault::Torn});
    // Cuts and cracks that close by themselves.
    EXPECT_EQ(faults_found(cut_apart(torus)), Faults());
    EXPECT_EQ(faults_found(shrunk_triangles(torus, 0.001)), Faults());
    PrecomputeOptions unwelded;
    unwelded.weld_duplicates = false;
    EXPECT_EQ(faults_found(cut_apart(torus), unwelded), Faults{MeshFault::Torn});
}

TriangleMesh rounded_to(double step, const TriangleMesh& mesh) {
    return mapped(mesh, [=](Eigen::Vector3d& p) { p = step * (p / step).array().round(); });
}

/// A tenth of the mean edge or more, wherever the mesh is; not the plain sizes of what was made.
TEST(MeshFaults, OfCoordinatesOfFewDigits) {
    const TriangleMesh far = moved(mesh_named("torus").mesh, {100, 20, -30});
    const double edge = precompute(far).scale.mean_edge;
    EXPECT_EQ(faults_found(rounded_to(0.08 * edge, far)), Faults());
    const MeshReport report = precompute(rounded_to(0.12 * edge, far)).report;
    EXPECT_NEAR(report.coordinate_step, 0.12 * edge, 1e-6);
    EXPECT_EQ(faults_of(report), Faults{MeshFault::Quantized});
    EXPECT_EQ(faults_found(rounded_to(0.4 * edge, far)), Faults{MeshFault::Quantized});
    EXPECT_EQ(faults_found(rounded_to_floats(rounded_to(0.12 * edge, far))),
              Faults{MeshFault::Quantized});
    EXPECT_EQ(faults_found(rounded_to(0.1, cube(40))), Faults());
}

}  // namespace
