// SPDX-License-Identifier: GPL-3.0-or-later
// The measures of a drawing, against drawings that are right, half there, or wrong by intent.
#include "drawing_measures.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "drawing_report.h"
#include "flat_scenes.h"
#include "generators.h"
#include "primitive_meshes.h"

namespace {

using namespace benchmarks;
using namespace flat_scenes;
using laplacian_lines::LineKind;
using laplacian_lines::TriangleMesh;
using laplacian_lines::View;

/// The square's border, clockwise from the upper left corner.
laplacian_lines::LineSet border_line(float half = 1) {
    return line(
        {{-half, half, 0}, {half, half, 0}, {half, -half, 0}, {-half, -half, 0}, {-half, half, 0}});
}

TEST(OutlineCompleteness, IsOneForTheMasksOwnOutline) {
    const TriangleMesh mesh = test_meshes::torus(32, 16).mesh;
    const PictureCamera camera(View::orthographic({0, 0.4, 1}), mesh, kSize);
    const PixelMask outline = DepthPicture(camera, mesh).outline();
    ASSERT_GT(outline.count(), 200u);
    EXPECT_EQ(drawn(outline, outline).value(), 1);
    EXPECT_EQ(drawn(outline, PixelMask(kSize)).value(), 0);
}

TEST(OutlineCompleteness, IsAHalfWithoutTheLinesOfOneHalf) {
    const TriangleMesh mesh = test_meshes::icosphere(4);
    const PictureCamera camera(View::orthographic({0, 0, 1}), mesh, 400);
    const PixelMask outline = DepthPicture(camera, mesh).outline();
    PixelMask half = outline;
    outline.for_each([&](int x, int y) {
        if (x >= 200) half.clear(x, y);
    });
    // Lines reach three pixels beyond their ends, above and below.
    const Share share = drawn(outline, half);
    EXPECT_NEAR(share.value(), 0.5 + 6.0 / double(share.all), 0.002);
}

TEST(OutlineCompleteness, IsThatOfTheLinesWithinThreePixels) {
    const TriangleMesh mesh = square();
    const PictureCamera camera = from_above(mesh);
    const PixelMask outline = DepthPicture(camera, mesh).outline();
    EXPECT_EQ(drawn(outline, line_pixels(camera, border_line(1))).value(), 1);
    EXPECT_EQ(drawn(outline, line_pixels(camera, border_line(0.93F))).value(), 1);
    EXPECT_EQ(drawn(outline, line_pixels(camera, border_line(0.85F))).value(), 0);
}

TEST(Strays, AreLinesInTheMiddleOfAFlatFace) {
    const TriangleMesh mesh = square();
    const PictureCamera camera = from_above(mesh);
    const DepthPicture surface(camera, mesh);
    const Share middle =
        strays(surface, line_pixels(camera, line({{-0.5F, 0, 0}, {0.5F, 0, 0}})), 1);
    EXPECT_GT(middle.all, 30u);
    EXPECT_EQ(middle.found, middle.all);
    EXPECT_EQ(strays(surface, line_pixels(camera, border_line()), 1).found, 0u);
}

TEST(Strays, AreLinesThatLeaveTheSurface) {
    const TriangleMesh mesh = square();
    const PictureCamera camera = from_above(mesh);
    const PixelMask outside = line_pixels(camera, border_line(1.15F));
    EXPECT_EQ(strays(DepthPicture(camera, mesh), outside, 1).value(), 1);
}

TEST(Strays, AreNotLinesAlongStepsAndEdges) {
    TriangleMesh mesh = square();
    test_meshes::append(mesh, square(0.5, 0.25));
    const PictureCamera camera = from_above(mesh);
    const Share step =
        strays(DepthPicture(camera, mesh), line_pixels(camera, border_line(0.5F)), 1);
    EXPECT_GT(step.all, 100u);
    EXPECT_EQ(step.found, 0u);

    const TriangleMesh cube = test_meshes::cube(2);
    const PictureCamera corner(View::orthographic({1, 1, 1}), cube, kSize);
    const DepthPicture sides(corner, cube);
    EXPECT_EQ(strays(sides, line_pixels(corner, line({{1, 1, 1}, {1, 1, -1}})), 1).value(), 0);
    EXPECT_GT(strays(sides, line_pixels(corner, line({{1, 0, 1}, {1, 0, -1}})), 1).value(), 0.7);
}

TEST(DrawingMeasures, OfCreasesAndSilhouettesOfACubeAreWithoutFault) {
    MeasureOptions options;
    options.size = 200;
    options.views = 4;
    options.style.mesh_silhouettes = true;
    options.style.shows[LineKind::Laplacian] = options.style.shows[LineKind::Ridge] = false;
    const MeshMeasures cube = measure_drawing(test_meshes::cube(4), options);
    ASSERT_EQ(cube.views.size(), 4u);
    for (const ViewMeasures& view : cube.views) {
        EXPECT_GT(view.outline.all, 300u);
        EXPECT_EQ(view.outline.value(), 1);
        EXPECT_EQ(view.strays.value(), 0);
        EXPECT_GT(view.edges.all, 400u);
        EXPECT_EQ(view.edges.value(), 1);
    }
    options.style.shows = {};
    const MeshMeasures empty = measure_drawing(test_meshes::cube(4), options);
    EXPECT_EQ(spread(empty, &ViewMeasures::outline).most, 0);
    EXPECT_EQ(spread(empty, &ViewMeasures::edges).most, 0);
    EXPECT_FALSE(spread(empty, &ViewMeasures::strays).is_known());
}

TEST(DrawingMeasures, AreTheSameEachTime) {
    MeasureOptions options;
    options.size = 100;
    options.views = 3;
    const auto report = [&] {
        return drawing_table({{"torus", "registered", false,
                               measure_drawing(test_meshes::torus(20, 10).mesh, options)}});
    };
    EXPECT_EQ(report(), report());
}

MeasuredDrawing made_up(const std::string& name, std::vector<Share> outlines) {
    MeasuredDrawing drawing{name, "files", false, {}};
    for (const Share& share : outlines)
        drawing.measures.views.push_back({share, {}, {}, false});
    return drawing;
}

TEST(DrawingMeasures, AreMeansOverTheViewsThatAreKnown) {
    const MeasuredDrawing drawing = made_up("a", {{1, 2}, {0, 0}, {1, 4}, {3, 4}});
    const Spread outline = spread(drawing.measures, &ViewMeasures::outline);
    EXPECT_EQ(outline.mean, 0.5);
    EXPECT_EQ(outline.least, 0.25);
    EXPECT_EQ(outline.least_view, 2);
    EXPECT_EQ(outline.most, 0.75);
    EXPECT_FALSE(spread(drawing.measures, &ViewMeasures::edges).is_known());
}

TEST(DrawingReports, BeginWithTheWorst) {
    std::vector<MeasuredDrawing> drawings = {made_up("unseen", {{0, 0}}), made_up("b", {{1, 1}}),
                                             made_up("half", {{1, 2}, {1, 1}}),
                                             made_up("a", {{1, 1}})};
    sort_by_worst(drawings);
    const char* expected[] = {"half", "a", "b", "unseen"};
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(drawings[i].name, expected[i]);
    EXPECT_NE(drawing_summary(drawings).find("all               3       2 ( 67 %)     0.917"),
              std::string::npos)
        << drawing_summary(drawings);
}

TEST(Primitives, AreClosedAndFaceOutwardsButForTheOpenOnes) {
    for (const Primitive& primitive : primitive_meshes()) {
        if (primitive.name == "torus_1000000") continue;  // as the others, but long
        const TriangleMesh mesh = primitive.make();
        ASSERT_EQ(without_unusable(mesh).triangles.size(), mesh.triangles.size()) << primitive.name;
        double volume = 0;
        Eigen::Vector3d area = Eigen::Vector3d::Zero();
        for (const laplacian_lines::Triangle& t : mesh.triangles) {
            const Eigen::Vector3d &a = mesh.positions[t[0]], &b = mesh.positions[t[1]],
                                  &c = mesh.positions[t[2]];
            volume += a.dot(b.cross(c)) / 6;
            area += (b - a).cross(c - a) / 2;
        }
        const bool is_flat = primitive.name == "sheet_2",
                   is_box = primitive.name.rfind("open_box", 0) == 0;
        // A closed surface has no area in sum; without its lid of 4, the box has that downwards.
        EXPECT_NEAR(area.norm(), is_flat || is_box ? 4 : 0, 1e-9) << primitive.name;
        if (!is_flat) {
            EXPECT_GT(volume, 0.01) << primitive.name;
        }
    }
}

}  // namespace
