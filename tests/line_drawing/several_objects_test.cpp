// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "line_drawing/sheet_file.h"
#include "sheet_helpers.h"
#include "with_threads.h"

using namespace line_drawing;
using Eigen::Vector3d;
using laplacian_lines::TriangleMesh;
using sheet_helpers::cube_of100;
using sheet_helpers::layer_of;
using sheet_helpers::length_of;
using sheet_helpers::painter_path;
using sheet_helpers::plain_views;
using sheet_helpers::with_sections;
using test_meshes::moved;

namespace {

/// 160 mm along x, 40 along y, 80 below the middle of cube_of100().
TriangleMesh plate() {
    return test_meshes::mapped(test_meshes::plane(16), [](Vector3d& p) {
        p = {80 * p.x(), 20 * p.y(), -80};
    });
}

/// Each with a field of its own.
Sheet sheet_of_all(const std::vector<TriangleMesh>& meshes, const SheetOptions& options) {
    std::vector<laplacian_lines::Field> fields;
    for (const TriangleMesh& mesh : meshes)
        fields.push_back(laplacian_lines::precompute(mesh));
    Objects objects;
    for (std::size_t i = 0; i < meshes.size(); ++i)
        objects.push_back({meshes[i], &fields[i]});
    return make_sheets(objects, {options}).front();
}

/// 100 mm of both long sides of its border.
TEST(SeveralObjects, ACubeHidesWhatIsBehindItOfAPlate) {
    SheetOptions options = plain_views("top");
    options.hidden = HiddenLines::Dashed;
    const SheetGroup view = sheet_of_all({cube_of100(), plate()}, options).groups[0];
    // The border is the plate's where it stands out on both sides, else the cube's.
    EXPECT_NEAR(length_of(layer_of(view, "outline")), 2 * 160 + 2 * 100, 1);
    EXPECT_NEAR(length_of(layer_of(view, "contour")), 2 * 40, 1);
    EXPECT_NEAR(length_of(layer_of(view, "hidden")), 2 * 100, 1);
    for (const SheetPath& path : layer_of(view, "hidden").paths)
        EXPECT_NEAR(painter_path(path.path).boundingRect().width(), 100, 0.5);
    options.views = parse_views("bottom", UpAxis::Z);  // now the plate is in front
    const SheetGroup below = sheet_of_all({cube_of100(), plate()}, options).groups[0];
    EXPECT_NEAR(length_of(layer_of(below, "outline")), 2 * 160 + 2 * 100, 1);
    EXPECT_NEAR(length_of(layer_of(below, "contour")), 2 * 100, 1);
}

TEST(SeveralObjects, HaveCommonBoundsAndOneScale) {
    const TriangleMesh cube = cube_of100();
    SheetOptions options = plain_views("front,left", "a4");
    options.scale = 0;
    const Sheet sheet = sheet_of_all({cube, moved(cube, {260, 0, 0})}, options);
    EXPECT_EQ(sheet.scale, 0.5);
    const QRectF front = sheet_helpers::extent_of(sheet.groups[0]),
                 left = sheet_helpers::extent_of(sheet.groups[1]);
    EXPECT_NEAR(front.width(), 360 * sheet.scale, 0.02);
    EXPECT_NEAR(left.width(), 100 * sheet.scale, 0.02);
    EXPECT_NEAR(front.top(), left.top(), 0.02);
}

/// Rising and falling lines.
std::pair<int, int> hatching_of(const SheetGroup& section) {
    int rising = 0, falling = 0;
    for (const SheetPath& path : layer_of(section, "fine").paths) {
        const QPointF span =
            painter_path(path.path).pointAtPercent(1) - painter_path(path.path).pointAtPercent(0);
        (span.x() * span.y() < 0 ? rising : falling)++;
    }
    return {rising, falling};
}

/// Touching cubes have two walls with different hatching.
TEST(SeveralObjects, EachHasItsOwnWallInSections) {
    SheetOptions options = with_sections("top", "z=0.3");
    const TriangleMesh cube = cube_of100();
    const Sheet sheet = sheet_of_all({cube, moved(cube, {100, 0, 0})}, options);
    EXPECT_EQ(layer_of(sheet.groups[1], "section").paths.size(), 2u);
    const auto [rising, falling] = hatching_of(sheet.groups[1]);
    EXPECT_GT(rising, 80);
    EXPECT_NEAR(rising, falling, 3);
    options.wall = WallStyle::Filled;
    const Sheet filled = sheet_of_all({cube, moved(cube, {100, 0, 0})}, options);
    int areas = 0;
    for (const SheetPath& path : layer_of(filled.groups[1], "section").paths)
        areas += path.pen_width == 0;
    EXPECT_EQ(areas, 2);
}

TEST(SeveralObjects, HaveOtherHatchingThanNeighbours) {
    const SheetOptions options = with_sections("", "z=0.1");
    const TriangleMesh cube = cube_of100();
    const TriangleMesh right = moved(cube, {100, 0, 0}), above = moved(cube, {0, 0, 150}),
                       apart = moved(cube, {-150, 0, 0});
    for (const auto& objects : {std::vector{cube, above, right}, {cube, apart, above, right}}) {
        const auto [rising, falling] = hatching_of(sheet_of_all(objects, options).groups[0]);
        EXPECT_GT(rising, 80);
        EXPECT_GT(falling, 80);
    }
}

/// Overlapping cubes are one body with one hatching.
TEST(SeveralObjects, ThatOverlapHaveOneWallInSections) {
    const SheetOptions options = with_sections("", "z=0.3");
    const TriangleMesh cube = cube_of100();
    const TriangleMesh other = moved(cube, {50, 20, 0}), inner = moved(cube, {20, 20, -20}, 0.2);
    const SheetGroup merged = sheet_of_all({cube, other, inner}, options).groups[0];
    // Two squares of 100 mm, less 50 and 80 of each within the other.
    EXPECT_NEAR(length_of(layer_of(merged, "section")), 2 * 400 - 2 * (50 + 80), 0.1);
    EXPECT_NEAR(length_of(layer_of(merged, "fine")) * 1.5, 2 * 100 * 100 - 50 * 80, 200);
    EXPECT_EQ(hatching_of(merged).second, 0);
    // Scans of fitting parts overlap slightly.
    const SheetGroup fitted = sheet_of_all({cube, moved(cube, {99.5, 0, 0})}, options).groups[0];
    EXPECT_GT(hatching_of(fitted).first, 80);
    EXPECT_NEAR(hatching_of(fitted).first, hatching_of(fitted).second, 3);
}

/// Also of hidden parts: the cube leaves no hole in that of the frame.
TEST(SeveralObjects, EachHasItsOwnAreaIfWanted) {
    SheetOptions options = plain_views("top");
    options.area = OutlineArea::Objects;
    const auto square = [](double half) {
        return test_meshes::circle(4, half * std::sqrt(2), -80, M_PI / 4);
    };
    const TriangleMesh frame = test_meshes::walls({square(80), square(60)});
    const Sheet sheet = sheet_of_all({moved(cube_of100(), {70, 0, 0}), frame}, options);
    const SheetLayer& layer = layer_of(sheet.groups[0], "area");
    ASSERT_EQ(layer.paths.size(), 2u);
    EXPECT_NEAR(sheet_helpers::area_of(layer.paths[0]), 100 * 100, 1e-6);
    EXPECT_NEAR(sheet_helpers::area_of(layer.paths[1]), 160 * 160 - 120 * 120, 1e-6);
    EXPECT_EQ(layer.paths[0].path.pieces.size(), 5u);  // four corners, and back
    EXPECT_EQ(layer.paths[1].path.pieces.size(), 10u);
    options.area = OutlineArea::Filled;
    const Sheet together = sheet_of_all({moved(cube_of100(), {70, 0, 0}), frame}, options);
    ASSERT_EQ(layer_of(together.groups[0], "area").paths.size(), 1u);
}

TEST(SeveralObjects, AreTheSameOnAnyNumberOfThreads) {
    const auto bumpy = moved(test_meshes::bumpy_sphere(4).mesh, {30, 0, -200}, 60);
    const auto draw = [&](int threads) {
        const test_meshes::WithThreads scope(threads);
        return write_sheet(sheet_of_all({cube_of100(), bumpy}, plain_views("six,30,20")), ".svg");
    };
    EXPECT_EQ(draw(1), draw(3));
}

}  // namespace
