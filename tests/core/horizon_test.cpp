// SPDX-License-Identifier: GPL-3.0-or-later
// Contours of coarse meshes are mesh edges, those of fine meshes are not.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "helpers.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace laplacian_lines;

LineStyle outlines(bool exact = true) {
    LineStyle style = helpers::all_contours();
    style.exact_outlines = exact;
    return style;
}

TEST(Horizon, IsBetweenFrontAndBackWhereTrianglesAreCoarse) {
    for (const TriangleMesh& mesh :
         {test_meshes::cube(1), test_meshes::icosphere(0), test_meshes::icosphere(2),
          test_meshes::torus(12, 8).mesh, test_meshes::moebius_strip(20, 2)}) {
        const LineExtractor extractor(mesh, precompute(mesh));
        for (const View& view : helpers::random_views(mesh, 6)) {
            const std::vector<helpers::Edge> horizon = helpers::horizon_of(mesh, view);
            EXPECT_EQ(helpers::edges_of(mesh, helpers::extract(extractor, view, outlines())),
                      std::multiset<helpers::Edge>(horizon.begin(), horizon.end()));
        }
    }
}

TEST(Horizon, IsClosedOnClosedMeshes) {
    for (const std::string& name : test_meshes::mesh_names()) {
        const TriangleMesh& mesh = test_meshes::mesh_named(name).mesh;
        if (!test_meshes::mesh_named(name).is_closed) continue;
        const LineExtractor extractor(mesh, precompute(mesh));
        for (const View& view : helpers::random_views(mesh, 8)) {
            const LineSet lines = helpers::extract(extractor, view, outlines());
            EXPECT_FALSE(lines.lines.empty()) << name;
            for (const Polyline& line : lines.lines)
                EXPECT_TRUE(line.closed) << name << ", " << line.count << " points";
        }
    }
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
    const TriangleMesh cube = test_meshes::cube(40);  // coarse at its edges, fine on the faces
    const LineExtractor extractor(cube, precompute(cube));
    const double largest = 0.003 * std::sqrt(12);  // .3 % of D
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
    TriangleMesh mesh =
        test_meshes::prism({{0, 0}, {0, 1}, {-1, 1}, {-1, -1}, {1, -1}, {1, 0}}, -1, 1);
    std::vector<Triangle>& all = mesh.triangles;
    const auto is_of_lid = [&](const Triangle& t) { return !has_lid && t[0] == 6; };
    all.erase(std::remove_if(all.begin(), all.end(), is_of_lid), all.end());
    return mesh;
}

/// Of an open surface the inside may be seen there: what is hidden is left to depths.
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

}  // namespace
