// SPDX-License-Identifier: GPL-3.0-or-later
// Borders and creases against plain counts of edges.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <set>
#include <thread>
#include <vector>

#include "edges_of_lines.h"
#include "helpers.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace laplacian_lines;
using helpers::Edge;
using helpers::edges_of;

LineStyle nothing() {
    LineStyle style = helpers::all_crossings();
    style.shows = LineKindSet();
    return style;
}

LineStyle borders() {
    LineStyle style = nothing();
    style.shows[LineKind::Border] = true;
    return style;
}

LineStyle creases(double angle) {
    LineStyle style = nothing();
    style.shows[LineKind::Crease] = true;
    style.crease_angle = angle;
    return style;
}

LineSet lines_of(const TriangleMesh& mesh, const LineStyle& style,
                 const View& view = View::perspective({3, 2, 4})) {
    return helpers::extract(LineExtractor(mesh, precompute(mesh)), view, style);
}

std::map<Edge, std::vector<Eigen::Vector4d>> planes_of_edges(const TriangleMesh& mesh) {
    std::map<Edge, std::vector<Eigen::Vector4d>> planes;
    for (const Triangle& t : mesh.triangles) {
        if (!helpers::has_area(mesh, t)) continue;
        const auto& p = mesh.positions;
        const Eigen::Vector3d n = (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).normalized();
        for (std::size_t k = 0; k < 3; ++k)
            planes[std::minmax(t[k], t[(k + 1) % 3])].push_back(
                {n.x(), n.y(), n.z(), -n.dot(p[t[0]])});
    }
    return planes;
}

/// Edges whose planes ask for a line.
template <class Wanted>
std::multiset<Edge> wanted_edges(const TriangleMesh& mesh, Wanted wanted) {
    std::multiset<Edge> edges;
    for (const auto& [edge, planes] : planes_of_edges(mesh))
        if (wanted(planes)) edges.insert(edge);
    return edges;
}

TEST(MeshEdgeLines, BordersAreEdgesWithoutTwoTriangles) {
    for (const char* name : {"plane", "half_torus", "three_sheets", "pillow", "torus", "cube",
                             "single_triangle", "moebius_strip"}) {
        const TriangleMesh& mesh = test_meshes::mesh_named(name).mesh;
        EXPECT_EQ(edges_of(mesh, lines_of(mesh, borders())),
                  wanted_edges(mesh, [](const auto& planes) { return planes.size() != 2; }))
            << name;
    }
}

TEST(MeshEdgeLines, BordersAreWholeLinesOfTheOutline) {
    const LineSet lines = lines_of(test_meshes::mesh_named("plane").mesh, borders());
    ASSERT_EQ(lines.lines.size(), 1u);
    EXPECT_TRUE(lines.lines[0].closed);
    EXPECT_TRUE(describe(lines.lines[0].kind).is_outline);
    EXPECT_EQ(lines.lines[0].kind, LineKind::Border);
    for (const LinePoint& p : lines.points)
        EXPECT_EQ(p.opacity * p.weight, 1);
}

TEST(MeshEdgeLines, CreasesAreTheEdgesOfACube) {
    const TriangleMesh& cube = test_meshes::mesh_named("cube").mesh;
    const LineSet lines = lines_of(cube, creases(60));
    EXPECT_EQ(lines.lines.size(), 12u);
    for (const LinePoint& p : lines.points)
        EXPECT_NEAR(p.gradient, 90, 1e-3);
    EXPECT_EQ(edges_of(cube, lines).size(), 12u * 10);
    EXPECT_TRUE(lines_of(cube, creases(91)).lines.empty());
}

TEST(MeshEdgeLines, CreasesNeedTheirAngle) {
    const TriangleMesh mesh = test_meshes::rounded_cube(4, 0.4);
    for (const double angle : {20., 30., 45.}) {
        const auto wanted = wanted_edges(mesh, [&](const auto& planes) {
            return planes.size() == 2 &&
                   planes[0].template head<3>().dot(planes[1].template head<3>()) <=
                       std::cos(angle * 3.14159265358979 / 180);
        });
        const auto found = edges_of(mesh, lines_of(mesh, creases(angle)));
        // Lines continue to a vertex where they are sharp enough, so none may be missing.
        for (const Edge& edge : wanted)
            EXPECT_EQ(found.count(edge), 1u) << angle;
    }
}

/// Found on first use, even by several threads at once.
TEST(MeshEdgeLines, CanBeAskedForByManyThreads) {
    const TriangleMesh& mesh = test_meshes::mesh_named("half_torus").mesh;
    LineStyle style = creases(20);
    style.shows[LineKind::Ridge] = style.shows[LineKind::Border] = style.shows[LineKind::Contour] =
        true;
    const Field field = precompute(mesh);
    const View view = View::perspective({3, 2, 4});
    const LineSet expected = helpers::extract(LineExtractor(mesh, field), view, style);
    ASSERT_FALSE(expected.lines.empty());
    const LineExtractor shared(mesh, field);
    std::vector<LineSet> found(4);
    std::vector<std::thread> threads;
    for (LineSet& lines : found)
        threads.emplace_back([&] { lines = helpers::extract(shared, view, style); });
    for (std::thread& thread : threads)
        thread.join();
    for (const LineSet& lines : found)
        EXPECT_TRUE(helpers::same_lines(lines, expected));
}

}  // namespace
