// SPDX-License-Identifier: GPL-3.0-or-later
// Creases are the edges of the form, on meshes of few triangles and of many.
#include <gtest/gtest.h>

#include <cmath>

#include "edges_of_lines.h"
#include "generators.h"
#include "helpers.h"
#include "laplacian_lines/precompute.h"
#include "mesh_noise.h"

namespace {

using namespace laplacian_lines;
using helpers::Edge;
using helpers::edges_of;

constexpr double kTurn = 6.283185307179586;

LineStyle creases_alone() {
    LineStyle style;
    style.shows = LineKindSet();
    style.shows[LineKind::Crease] = true;
    return style;
}

LineSet creases_of(const TriangleMesh& mesh, const LineStyle& style = creases_alone(),
                   const View& view = View::perspective({3, 2, 4})) {
    return helpers::extract(LineExtractor(mesh, precompute(mesh)), view, style);
}

/// A closed solid around the z axis: rings of these radii and heights, with a middle at either end.
TriangleMesh turned(std::uint32_t sides, const std::vector<std::pair<double, double>>& rings) {
    TriangleMesh mesh;
    for (const auto& [radius, z] : rings)
        for (std::uint32_t i = 0; i < sides; ++i)
            mesh.positions.push_back(
                {radius * std::cos(kTurn * i / sides), radius * std::sin(kTurn * i / sides), z});
    const auto bottom = std::uint32_t(mesh.positions.size());
    mesh.positions.push_back({0, 0, rings.front().second});
    mesh.positions.push_back({0, 0, rings.back().second});
    const std::uint32_t last = bottom - sides;
    for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t next = (i + 1) % sides;
        mesh.triangles.push_back({next, i, bottom});
        mesh.triangles.push_back({last + i, last + next, bottom + 1});
        for (std::uint32_t ring = 0; ring < last; ring += sides) {
            mesh.triangles.push_back({ring + i, ring + next, ring + sides + next});
            mesh.triangles.push_back({ring + i, ring + sides + next, ring + sides + i});
        }
    }
    return mesh;
}

/// Edges of a line set that go along the rings of turned().
std::size_t edges_on_rings(const TriangleMesh& mesh, const LineSet& lines) {
    std::size_t count = 0;
    for (const Edge& edge : edges_of(mesh, lines))
        count += mesh.positions[edge.first].z() == mesh.positions[edge.second].z();
    return count;
}

TEST(Creases, AreTheTwelveEdgesOfACubeOfAnyFineness) {
    for (const int cells : {1, 2, 10, 40}) {
        const LineSet lines = creases_of(test_meshes::cube(cells));
        ASSERT_EQ(lines.lines.size(), 12u) << cells;
        for (const Polyline& line : lines.lines) {
            EXPECT_EQ(line.count, std::uint32_t(cells) + 1);
            EXPECT_NEAR(line.length, 2 / std::sqrt(12.), 1e-5);
        }
        for (const LinePoint& p : lines.points) {
            EXPECT_NEAR(p.gradient, 90, 1e-3);
            EXPECT_EQ(p.opacity * p.weight, 1);
        }
    }
}

TEST(Creases, DoNotMindTrianglesOfBothOrientations) {
    for (const int cells : {1, 10, 30}) {
        TriangleMesh mesh = test_meshes::cube(cells);
        const auto expected = edges_of(mesh, creases_of(mesh));
        test_meshes::flip_triangles(mesh, 3);
        EXPECT_EQ(edges_of(mesh, creases_of(mesh)), expected) << cells;
    }
}

TEST(Creases, AreNotOnRoundForms) {
    for (int level = 1; level <= 4; ++level)
        EXPECT_TRUE(creases_of(test_meshes::icosphere(level)).lines.empty()) << level;
    for (const int columns : {24, 32, 80})
        EXPECT_TRUE(creases_of(test_meshes::torus(columns, columns / 2).mesh).lines.empty())
            << columns;
}

TEST(Creases, AreTheRimsOfCylindersAndNotTheirSides) {
    for (const std::uint32_t sides : {12u, 24u, 48u}) {
        const TriangleMesh mesh = turned(sides, {{0.5, -1}, {0.5, 1}});
        const LineSet lines = creases_of(mesh);
        EXPECT_EQ(lines.lines.size(), 2u) << sides;
        EXPECT_EQ(edges_of(mesh, lines).size(), 2 * sides);
        EXPECT_EQ(edges_on_rings(mesh, lines), 2 * sides);
    }
}

TEST(Creases, AreTheSidesOfPrismsOfFewSides) {
    for (const std::uint32_t sides : {3u, 6u, 8u})
        EXPECT_EQ(edges_of(turned(sides, {{0.5, -1}, {0.5, 1}}),
                           creases_of(turned(sides, {{0.5, -1}, {0.5, 1}})))
                      .size(),
                  3 * sides);
}

/// Below the angle of the style, if the surface beside them is flat: between a cylinder and a
/// shallow cone on it.
TEST(Creases, AreWeakEdgesBetweenFlatterForms) {
    for (const std::uint32_t sides : {12u, 48u}) {
        const TriangleMesh mesh = turned(sides, {{0.5, -1}, {0.5, 0.5}, {0.3, 1}});
        const LineSet lines = creases_of(mesh);
        EXPECT_EQ(edges_of(mesh, lines).size(), 3 * sides) << sides;
        EXPECT_EQ(edges_on_rings(mesh, lines), 3 * sides);
        LineStyle sharper = creases_alone();
        sharper.crease_angle = 45;
        EXPECT_EQ(edges_of(mesh, creases_of(mesh, sharper)).size(), 2 * sides);
    }
}

TEST(Creases, OfASmallerAngleAreMore) {
    const TriangleMesh mesh = turned(12, {{0.5, -1}, {0.5, 1}});
    LineStyle style = creases_alone();
    style.crease_angle = 20;
    EXPECT_EQ(edges_of(mesh, creases_of(mesh, style)).size(), 3u * 12);
    // The sides, at 30°, end lines at the rims: 24 of one edge each, beside 12 sides.
    style.crease_angle = 31;
    EXPECT_EQ(creases_of(mesh, style).lines.size(), 2u);
}

TEST(Creases, AreHardlyAnyOnNoisyScans) {
    const TriangleMesh mesh = test_meshes::bumpy_sphere(6).mesh;  // 81,920 triangles
    EXPECT_EQ(helpers::total_length(creases_of(mesh)), 0);
    for (const double noise : {0.2, 0.4}) {
        const TriangleMesh noisy = mesh_noise::with_noise(mesh, noise);
        EXPECT_LT(helpers::total_length(creases_of(noisy)), noise < 0.3 ? 0.05 : 2) << noise;
    }
}

/// The contour is there, so an edge between a face that is seen and one that is not is left out.
TEST(Creases, AreLeftOutOnTheHorizon) {
    for (const int cells : {1, 10}) {
        const TriangleMesh mesh = test_meshes::cube(cells);
        const View view = View::perspective({3, 2, 4});  // sees three faces
        LineStyle style = creases_alone();
        style.shows[LineKind::Contour] = true;
        LineSet lines = creases_of(mesh, style, view);
        LineSet creases;
        creases.points = lines.points;
        for (const Polyline& line : lines.lines)
            if (line.kind == LineKind::Crease) creases.lines.push_back(line);
        EXPECT_EQ(creases.lines.size(), 6u);
        const auto edges = edges_of(mesh, creases);
        EXPECT_EQ(edges.size(), 6u * unsigned(cells));
        for (const Edge& edge : edges) {
            const Eigen::Vector3d middle =
                (mesh.positions[edge.first] + mesh.positions[edge.second]) / 2;
            int towards = 0;
            for (int k = 0; k < 3; ++k)
                towards += std::abs(std::abs(middle[k]) - 1) < 1e-9 ? (middle[k] > 0 ? 1 : -1) : 0;
            EXPECT_EQ(std::abs(towards), 2);  // between two that are seen, or two that are not
        }
    }
}

/// Of a closed line, what is left are whole arcs.
TEST(Creases, AreCutWhereTheHorizonBegins) {
    const std::uint32_t sides = 48;
    const TriangleMesh mesh = turned(sides, {{0.5, -1}, {0.5, 1}});
    LineStyle style = creases_alone();
    style.shows[LineKind::Contour] = true;
    // From above: the lid is seen, and half of the wall.
    const LineSet lines = creases_of(mesh, style, View::perspective({4, 0.1, 6}));
    std::size_t arcs = 0, edges = 0;
    for (const Polyline& line : lines.lines) {
        if (line.kind != LineKind::Crease) continue;
        ++arcs;
        edges += line.count - 1;
        EXPECT_FALSE(line.closed);
        float length = 0;
        for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i)
            length += (lines.points[i].position - lines.points[i - 1].position).norm();
        EXPECT_NEAR(line.length * std::sqrt(6.), length, 1e-4);  // D
    }
    EXPECT_EQ(arcs, 2u);
    EXPECT_EQ(edges, sides);  // each side of the wall is in one of the two
}

}  // namespace
