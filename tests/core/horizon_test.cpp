// SPDX-License-Identifier: GPL-3.0-or-later
// Contours where triangles are coarse: mesh edges, joined to the smooth contours elsewhere.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "clusters/coarseness.h"
#include "helpers.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace laplacian_lines;

LineStyle outlines(bool exact = true) {
    LineStyle style = helpers::all_contours();
    style.exact_outlines = exact;
    return style;
}

/// By triangle; all have an area.
std::vector<std::uint8_t> coarse_triangles(const TriangleMesh& mesh, const Field& field) {
    return find_coarse_triangles(prepare_geometry(mesh, Cuts::Left), field);
}

using Place = std::array<long, 3>;
using Segment = std::pair<Place, Place>;

/// Rounded.
Place place(const Eigen::Vector3f& p) {
    const auto rounded = [](float x) { return std::lround(1e4f * x); };
    return {rounded(p.x()), rounded(p.y()), rounded(p.z())};
}

Segment segment(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
    return std::minmax(place(a), place(b));
}

std::multiset<Segment> segments_of(const LineSet& lines) {
    std::multiset<Segment> segments;
    for (const Polyline& line : lines.lines)
        for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i)
            segments.insert(segment(lines.points[i - 1].position, lines.points[i].position));
    return segments;
}

struct Face {
    std::size_t triangle;
    bool faces;  ///< the eye, as the other triangle of the edge is oriented
    bool coarse;
};

/// For edges with two triangles.
std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Face>> faces_of_edges(
    const TriangleMesh& mesh, const std::vector<std::uint8_t>& coarse, const View& view) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Face>> faces;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        const auto& p = mesh.positions;
        const Eigen::Vector3d n = (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]);
        const bool faces_eye = n.dot(view.eye - view.w * p[t[0]]) >= 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            // In the direction from the smaller vertex to the larger one.
            faces[std::minmax(a, b)].push_back({i, faces_eye == (a < b), coarse[i] != 0});
        }
    }
    return faces;
}

/// Edges between coarse triangles are drawn just where front meets back.
void expect_edges_of_horizon(const TriangleMesh& mesh) {
    const Field field = precompute(mesh);
    const LineExtractor extractor(mesh, field);
    const std::vector<std::uint8_t> coarse = coarse_triangles(mesh, field);
    std::size_t drawn = 0;
    for (const View& view : helpers::random_views(mesh, 6)) {
        const std::multiset<Segment> found =
            segments_of(helpers::extract(extractor, view, outlines()));
        for (const auto& [edge, faces] : faces_of_edges(mesh, coarse, view)) {
            if (faces.size() != 2 || !faces[0].coarse || !faces[1].coarse) continue;
            // Both faces are on their own side of the edge, so equal entries mean front and back.
            const bool is_horizon = faces[0].faces == faces[1].faces;
            const std::size_t times =
                found.count(segment(mesh.positions[edge.first].cast<float>(),
                                    mesh.positions[edge.second].cast<float>()));
            EXPECT_EQ(times, is_horizon ? 1u : 0u);
            drawn += times;
        }
    }
    EXPECT_GT(drawn, 0u);
}

TEST(Horizon, IsBetweenFrontAndBackWhereTrianglesAreCoarse) {
    expect_edges_of_horizon(test_meshes::cube(1));
    expect_edges_of_horizon(test_meshes::icosphere(0));
    expect_edges_of_horizon(test_meshes::icosphere(2));
    expect_edges_of_horizon(test_meshes::torus(12, 8).mesh);
    expect_edges_of_horizon(test_meshes::moebius_strip(20, 2));
}

TEST(Horizon, DoesNotMindOrientation) {
    TriangleMesh cube = test_meshes::cube(3);
    for (std::size_t i = 0; i < cube.triangles.size(); i += 2)
        std::swap(cube.triangles[i][0], cube.triangles[i][1]);
    const LineExtractor extractor(cube, precompute(cube));
    const LineSet lines =
        helpers::extract(extractor, View::orthographic({0.5, 0.7, 1}), outlines());
    EXPECT_NEAR(helpers::total_length(lines) * std::sqrt(12.), 6 * 2, 1e-4);
}

/// Coarse at some edges, fine on the faces.
TriangleMesh half_fine_cube() {
    return test_meshes::cube(40);
}

TEST(Horizon, IsClosedOnClosedMeshes) {
    for (const test_meshes::MeshEntry* entry : test_meshes::meshes_with(test_meshes::kClosed)) {
        const TriangleMesh& mesh = entry->get().mesh;
        const LineExtractor extractor(mesh, precompute(mesh));
        for (const View& view : helpers::random_views(mesh, 20))
            for (const Polyline& line : helpers::extract(extractor, view, outlines()).lines)
                EXPECT_TRUE(line.closed) << entry->name << ", " << line.count << " points";
    }
}

TEST(Horizon, GoesFromEdgesToSmoothContoursAndBack) {
    const TriangleMesh mesh = test_meshes::torus(80, 40).mesh;
    const Field field = precompute(mesh);
    const std::vector<std::uint8_t> coarse = coarse_triangles(mesh, field);
    const auto count = std::count(coarse.begin(), coarse.end(), 1);
    ASSERT_GT(count, 0);
    ASSERT_LT(count, std::ptrdiff_t(coarse.size()));
    std::set<Place> vertices;
    for (const Eigen::Vector3d& p : mesh.positions)
        vertices.insert(place(p.cast<float>()));
    const LineExtractor extractor(mesh, field);
    std::size_t mixed = 0;
    for (const View& view : helpers::random_views(mesh, 10)) {
        const LineSet lines = helpers::extract(extractor, view, outlines());
        for (const Polyline& line : lines.lines) {
            EXPECT_TRUE(line.closed);
            std::size_t at_vertices = 0;
            for (std::uint32_t i = line.first; i < line.first + line.count; ++i)
                at_vertices += vertices.count(place(lines.points[i].position));
            mixed += at_vertices > 0 && at_vertices < line.count;
        }
    }
    EXPECT_GT(mixed, 0u);
}

TEST(Horizon, IsThatOfSmoothContoursOnFineMeshes) {
    const TriangleMesh mesh = test_meshes::torus(200, 100).mesh;
    const LineExtractor extractor(mesh, precompute(mesh));
    for (const View& view : helpers::random_views(mesh, 5)) {
        const LineSet lines = helpers::extract(extractor, view, outlines());
        ASSERT_FALSE(lines.lines.empty());
        EXPECT_TRUE(helpers::same_lines(lines, helpers::extract(extractor, view, outlines(false))));
    }
}

TEST(Horizon, IsNotMovedBySmoothing) {
    LineStyle smoothing = outlines();
    smoothing.line_smoothing = 3;
    const TriangleMesh cube = test_meshes::cube(1);
    const LineExtractor extractor(cube, precompute(cube));
    for (const View& view : helpers::random_views(cube, 10)) {
        const LineSet lines = helpers::extract(extractor, view, smoothing);
        EXPECT_FALSE(lines.lines.empty());
        EXPECT_TRUE(helpers::same_lines(lines, helpers::extract(extractor, view, outlines())));
    }
}

TEST(Horizon, StaysAtTheEdges) {
    const TriangleMesh cube = half_fine_cube();
    const LineExtractor extractor(cube, precompute(cube));
    const double largest = 0.003 * std::sqrt(12);
    for (const View& view : helpers::random_views(cube, 10)) {
        const LineSet lines = helpers::extract(extractor, view, outlines());
        EXPECT_GT(helpers::total_length(lines) * std::sqrt(12), 4 * 2 - 0.01);
        for (const LinePoint& p : lines.points) {
            std::array<float, 3> inside;  // below the faces of the cube
            for (int k = 0; k < 3; ++k)
                inside[std::size_t(k)] = 1 - std::abs(p.position[k]);
            std::sort(inside.begin(), inside.end());
            const Eigen::Vector3d towards = (view.eye - view.w * p.position.cast<double>());
            // The second smallest is the distance from an edge, on a face; foreshortened.
            const double least_cosine = towards.normalized().cwiseAbs().minCoeff();
            EXPECT_LE(inside[1] * std::min(1., 2 * least_cosine), largest);
        }
    }
}

/// An L upright, whose inner corner is at (0, 0), with a floor.
TriangleMesh l_shaped(bool has_lid) {
    const std::array<std::array<double, 2>, 6> outline = {
        {{0, 0}, {0, 1}, {-1, 1}, {-1, -1}, {1, -1}, {1, 0}}};
    TriangleMesh mesh;
    for (const double z : {-1., 1.})
        for (const auto& [x, y] : outline)
            mesh.positions.emplace_back(x, y, z);
    for (std::uint32_t i = 0; i < 6; ++i) {
        const std::uint32_t next = (i + 1) % 6;
        mesh.triangles.push_back({i, next, next + 6});
        mesh.triangles.push_back({i, next + 6, i + 6});
        if (next < 2) continue;
        mesh.triangles.push_back({0, next, i});
        if (has_lid) mesh.triangles.push_back({6, i + 6, next + 6});
    }
    return mesh;
}

/// That is left to depths where a wall is seen from inside.
TEST(Horizon, IsHiddenInHollowsOfBodiesOnly) {
    for (const bool has_lid : {true, false}) {
        const TriangleMesh mesh = l_shaped(has_lid);
        const LineSet lines = helpers::extract(LineExtractor(mesh, precompute(mesh)),
                                               View::orthographic({-1, 0.4, 0.6}), outlines());
        std::size_t in_hollow = 0;
        for (const LinePoint& p : lines.points) {
            if (p.position.head<2>().norm() > 1e-6) continue;
            ++in_hollow;
            EXPECT_EQ(std::signbit(p.gradient), has_lid);
        }
        EXPECT_EQ(in_hollow, 2u);
    }
}

/// Merely bad triangles, as in scans.
TEST(Coarseness, LeavesOutSmallPatches) {
    TriangleMesh mesh = test_meshes::sphere(6).mesh;
    const auto coarse_count = [&] {
        const std::vector<std::uint8_t> coarse = coarse_triangles(mesh, precompute(mesh));
        return std::count(coarse.begin(), coarse.end(), 1);
    };
    EXPECT_EQ(coarse_count(), 0);
    mesh.positions[100] *= 0.97;
    EXPECT_EQ(coarse_count(), 0);
    mesh.positions[100] *= 0.8;
    EXPECT_GT(coarse_count(), 0);
}

/// Contours would alternate with smooth ones where a few triangles are fine.
TEST(Coarseness, IsOfAllTrianglesWhereMostAreCoarse) {
    for (const TriangleMesh& mesh :
         {test_meshes::rounded_cube(24, 0.3), test_meshes::rounded_cube(24, 0.4)}) {
        const Field field = precompute(mesh);
        const std::vector<std::uint8_t> coarse = coarse_triangles(mesh, field);
        EXPECT_EQ(std::count(coarse.begin(), coarse.end(), 0), 0);
        std::set<Place> vertices;
        for (const Eigen::Vector3d& p : mesh.positions)
            vertices.insert(place(p.cast<float>()));
        const LineExtractor extractor(mesh, field);
        for (const View& view : helpers::random_views(mesh, 5))
            for (const LinePoint& p : helpers::extract(extractor, view, outlines()).points) {
                EXPECT_EQ(vertices.count(place(p.position)), 1u);
                EXPECT_EQ(p.gradient, 0) << "not told from smooth ones";
            }
    }
}

TEST(Coarseness, GoesByTheSizeOfTheDrawing) {
    const auto share = [](const TriangleMesh& mesh) {
        const std::vector<std::uint8_t> coarse = coarse_triangles(mesh, precompute(mesh));
        return double(std::count(coarse.begin(), coarse.end(), 1)) / double(coarse.size());
    };
    EXPECT_EQ(share(test_meshes::icosphere(1)), 1);
    EXPECT_EQ(share(test_meshes::icosphere(5)), 0);
    EXPECT_EQ(share(test_meshes::cube(4)), 1);
    EXPECT_GT(share(half_fine_cube()), 0.05);
    EXPECT_LT(share(half_fine_cube()), 0.3);
    // The edges of what was made are coarse, however fine the triangles beside them.
    EXPECT_GT(share(test_meshes::cube(200)), 0);
    EXPECT_LT(share(test_meshes::cube(200)), 0.2);
}

}  // namespace
