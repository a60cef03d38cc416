// SPDX-License-Identifier: GPL-3.0-or-later
// Fields do not depend on which way round a file has its triangles.
#include <gtest/gtest.h>

#include "helpers.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace laplacian_lines;
using namespace test_meshes;

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
    ASSERT_EQ(lines.points.size(), others.points.size());
    for (std::size_t i = 0; i < lines.points.size(); ++i)
        EXPECT_EQ(lines.points[i].position, others.points[i].position);
}

TEST(Orientation, ClosedBodiesAreReadTheRightWayRound) {
    for (const char* name : {"torus", "rounded_cube"})
        for (const int every : {1, 3}) {
            TriangleMesh turned = mesh_named(name).mesh;
            flip_triangles(turned, every);
            expect_same_bits(mesh_named(name).mesh, turned);
            EXPECT_GT(precompute(turned).report.turned_triangles, 0u);
        }
}

TEST(Orientation, CutsThatDisagreeAreClosed) {
    TriangleMesh soup = cut_apart(mesh_named("torus").mesh);
    const Field field = precompute(soup);
    flip_triangles(soup, 3);
    EXPECT_EQ(precompute(soup).normals, field.normals);
}

/// A shell with a ball in its cavity.
TEST(Orientation, CavitiesStay) {
    TriangleMesh mesh = inside_out(moved(icosphere(3), {1, 2, 3}, 0.8));
    append(mesh, moved(icosphere(3), {1, 2, 3}));
    append(mesh, moved(icosphere(3), {1, 2, 3}, 0.4));
    for (const bool is_inverted : {false, true}) {
        if (is_inverted) mesh = inside_out(mesh);
        const Field field = precompute(mesh);
        EXPECT_EQ(field.report.turned_triangles, is_inverted ? mesh.triangles.size() : 0);
        EXPECT_GT(facing(field, mesh, {1, 2, 3}, 0.9, 1.1), 0.99);
        EXPECT_LT(facing(field, mesh, {1, 2, 3}, 0.7, 0.9), -0.99);
        EXPECT_GT(facing(field, mesh, {1, 2, 3}, 0, 0.5), 0.99);
    }
    TriangleMesh beside = inside_out(moved(icosphere(3), {4, 2, 3}));
    append(beside, mesh);
    EXPECT_GT(facing(precompute(beside), beside, {4, 2, 3}, 0, 1.1), 0.99);
}

/// Two cubes with as many vertices in common as are at one place.
TriangleMesh touching_cubes(const Eigen::Vector3d& by, double size) {
    TriangleMesh mesh = cube(1);
    const std::size_t own = mesh.positions.size();
    append(mesh, inside_out(moved(cube(1), by, size)));
    for (Triangle& t : mesh.triangles)
        for (std::uint32_t& v : t)
            for (std::uint32_t other = 0; other < own; ++other)
                if (mesh.positions[v] == mesh.positions[other]) v = other;
    return mesh;
}

TEST(Orientation, BodiesThatTouchAreBodiesOfTheirOwn) {
    for (const TriangleMesh& mesh :
         {touching_cubes({1.5, 1.5, 1.5}, 0.5), touching_cubes({2, 2, 0}, 1)})
        EXPECT_EQ(precompute(mesh).report.turned_triangles, 12u);
}

TEST(Orientation, OpenSurfacesKeepTheSideOfMostOfTheirArea) {
    const TriangleMesh& hills = mesh_named("hills").mesh;
    TriangleMesh few = hills;
    flip_triangles(few, 3);
    EXPECT_EQ(precompute(few).normals, precompute(hills).normals);
    EXPECT_EQ(precompute(inside_out(hills)).report.turned_triangles, 0u);
}

/// Folds back by a thousandth of the diagonal of a square that is cut in four.
TEST(Orientation, FoldedNeedlesTurnTheirBackForNoForm) {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {100, 0, 0}, {100, 100, 0}, {0, 100, 0}, {50.001, 49.999, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 4}, {0, 4, 3}, {4, 2, 3}};
    const Field field = precompute(mesh);
    LineStyle style;
    style.shows = LineKindSet();
    style.shows[LineKind::Contour] = style.shows[LineKind::Crease] = true;
    const LineExtractor extractor(mesh, field);
    for (const Eigen::Vector3d& eye : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(1, 2, 3)})
        EXPECT_TRUE(helpers::extract(extractor, View::orthographic(eye), style).lines.empty());
}

}  // namespace
