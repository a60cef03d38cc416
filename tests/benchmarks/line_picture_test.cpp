// SPDX-License-Identifier: GPL-3.0-or-later
// Lines and edges as pixels.
#include "line_picture.h"

#include <gtest/gtest.h>

#include <set>

#include "flat_scenes.h"
#include "generators.h"

namespace {

using namespace benchmarks;
using namespace flat_scenes;
using laplacian_lines::LineSet;
using laplacian_lines::TriangleMesh;
using laplacian_lines::View;

TEST(PixelMasks, GrowByAllPixelsWithinTheRadius) {
    PixelMask mask(20);
    mask.set(10, 10);
    mask.set(-1, 5);  // beside the picture
    const PixelMask grown = mask.grown(3);
    EXPECT_EQ(grown.count(), 29u);
    EXPECT_TRUE(grown.has(13, 10));
    EXPECT_TRUE(grown.has(12, 12));
    EXPECT_FALSE(grown.has(13, 11));
    PixelMask corner(20);
    corner.set(0, 0);
    EXPECT_EQ(corner.grown(3).count(), 11u);
}

TEST(LinePictures, HoldEachPixelALinePasses) {
    const TriangleMesh mesh = square();
    const PictureCamera camera = from_above(mesh);
    const PixelMask flat = line_pixels(camera, line({{-1, 0.01F, 0}, {0.99F, 0.01F, 0}}));
    EXPECT_EQ(flat.count(), 80u);
    EXPECT_TRUE(flat.has(10, 49));
    EXPECT_TRUE(flat.has(89, 49));
    const PixelMask bent =
        line_pixels(camera, line({{-0.89F, -0.89F, 0}, {0.1F, 0, 0}, {0, 0.89F, 0}}));
    std::set<int> rows;
    bent.for_each([&](int, int y) { rows.insert(y); });
    EXPECT_EQ(*rows.begin(), 14);
    EXPECT_EQ(*rows.rbegin(), 85);
    EXPECT_EQ(rows.size(), 72u);
}

TEST(LinePictures, LeaveOutWhatHasTooLittleInk) {
    const TriangleMesh mesh = square();
    const PictureCamera camera = from_above(mesh);
    LineSet faint = line({{-1, 0.01F, 0}, {1, 0.01F, 0}});
    faint.points[0].opacity = 0;
    faint.points[1].weight = 0.5F;
    // From 0 to 1 in opacity and from 1 to 0.5 in weight: 0.1 is reached at 0.1056 of 80 pixels.
    const PixelMask pixels = line_pixels(camera, faint);
    EXPECT_FALSE(pixels.has(17, 49));
    EXPECT_TRUE(pixels.has(19, 49));
    EXPECT_TRUE(pixels.has(89, 49));
    for (auto& p : faint.points)
        p.weight = p.opacity = 0.3F;
    EXPECT_EQ(line_pixels(camera, faint).count(), 0u);
}

TEST(LinePictures, DoNotJoinOneLineToTheNext) {
    const TriangleMesh mesh = square();
    LineSet lines = line({{-1, 1, 0}, {-1, 0.5F, 0}, {1, -0.5F, 0}, {1, -1, 0}});
    lines.lines[0].count = 2;
    lines.lines.push_back({2, 2, laplacian_lines::LineKind::Contour});
    EXPECT_FALSE(line_pixels(from_above(mesh), lines).grown(3).has(50, 50));
}

TEST(SharpEdges, OfACubeAreItsTwelveHoweverManyTriangles) {
    EXPECT_EQ(sharp_edges(test_meshes::cube(1), 40).size(), 12u);
    EXPECT_EQ(sharp_edges(test_meshes::cube(4), 40).size(), 48u);
    EXPECT_EQ(sharp_edges(test_meshes::cube(4), 90).size(), 48u);
    EXPECT_EQ(sharp_edges(test_meshes::cube(4), 91).size(), 0u);
}

TEST(SharpEdges, AreFoundWithoutSharedVerticesAndAgreement) {
    TriangleMesh mesh = test_meshes::cube(4);
    test_meshes::flip_triangles(mesh, 3);
    EXPECT_EQ(sharp_edges(mesh, 40).size(), 48u);
    EXPECT_EQ(sharp_edges(test_meshes::cut_apart(mesh), 40).size(), 48u);
}

TEST(SharpEdges, AreNeitherBordersNorWhereThreeTrianglesMeet) {
    EXPECT_EQ(sharp_edges(square(), 40).size(), 0u);
    EXPECT_EQ(sharp_edges(test_meshes::book(3), 40).size(), 0u);
    EXPECT_EQ(sharp_edges(test_meshes::book(2), 40).size(), 1u);
}

TEST(EdgePictures, LeaveOutTheEdgesOnTheFarSide) {
    const TriangleMesh mesh = test_meshes::cube(1);
    for (const View& view : {View::orthographic({1, 1, 1}), View::perspective({6, 6, 6})}) {
        const PictureCamera camera(view, mesh, kSize);
        const DepthPicture surface(camera, mesh);
        const auto pixels = [&](const std::vector<EdgeEnds>& edges) {
            return edge_pixels(camera, surface, edges, 0.01);
        };
        // Three edges begin at the corner in the middle; three more end behind it.
        EXPECT_GT(pixels({{{1, 1, 1}, {1, 1, -1}}}).count(), 30u);
        EXPECT_LT(pixels({{{-1, -1, -1}, {-1, -1, 0.8}}}).count(), 4u);
        EXPECT_GT(pixels({{{1, -1, 1}, {1, -1, -1}}}).count(), 30u);
        // In the picture, one of the three runs down, and one of those behind it up.
        const PixelMask all = pixels(sharp_edges(mesh, 40));
        const Eigen::Vector3d corner = camera.project({1, 1, 1});
        const int x = int(corner.x()), y = int(corner.y());
        EXPECT_TRUE(all.grown(1.5).has(x, y));
        EXPECT_TRUE(all.grown(1.5).has(x, y + 15));
        EXPECT_FALSE(all.grown(1.5).has(x, y - 15));
    }
}

}  // namespace
