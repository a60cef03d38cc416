// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines are closed and whole; missing parts are found by independent means.
#include "sight/observer.h"

#include <gtest/gtest.h>

#include "made_sheets.h"
#include "thrown_vessel.h"

using namespace line_drawing;
using Eigen::Vector2d;
using Eigen::Vector3d;
using made_sheets::cubeOf100;
using made_sheets::layerOf;
using made_sheets::plainViews;

namespace {

constexpr double pixel = 0.25;

/// The cube's front view, from corner to corner `sides` times.
DrawnLine squareOutline(int sides) {
    DrawnLine line{LineClass::Outline, sides == 4, {}};
    const Vector2d corners[] = {{-50, -50}, {50, -50}, {50, 50}, {-50, 50}, {-50, -50}};
    for (int i = 0; i <= sides; ++i)
        line.points.push_back({corners[i]});
    return line;
}

std::vector<Vector2d> missingOf(const std::vector<DrawnLine>& lines) {
    const ViewFrame front = frameOfSide(Side::Front, UpAxis::Z);
    const Projection projection(front, Vector3d::Zero());
    const Eigen::AlignedBox2d bounds(Vector2d(-50, -50), Vector2d(50, 50));
    return borderWithoutOutline(cubeOf100(), projection, 1, bounds, lines, pixel);
}

TEST(OutlineCheck, HasNothingToSayOfAWholeOutline) {
    EXPECT_TRUE(missingOf({squareOutline(4)}).empty());
}

TEST(OutlineCheck, FindsTheSideThatIsMissing) {
    const std::vector<Vector2d> missing = missingOf({squareOutline(3)});
    EXPECT_NEAR(pixel * double(missing.size()), 100, 2);
    for (const Vector2d& p : missing)
        EXPECT_NEAR(p.x(), -50, 2 * pixel);
}

/// Other classes do not count.
TEST(OutlineCheck, WantsOutlines) {
    DrawnLine contour = squareOutline(4);
    contour.line_class = LineClass::Contour;
    EXPECT_NEAR(pixel * double(missingOf({contour}).size()), 400, 4);
}

TEST(OutlineCheck, TakesOfOtherLinesWhatIsThere) {
    const std::vector<Vector2d> missing = missingOf({squareOutline(3)});
    DrawnLine hidden = squareOutline(4);
    hidden.line_class = LineClass::Hidden;
    hidden.points.push_back({{30, 30}});
    const std::vector<DrawnLine> found = linesAt(missing, {hidden}, pixel);
    ASSERT_FALSE(found.empty());
    for (const DrawnLine& line : found)
        EXPECT_EQ(line.line_class, LineClass::Outline);
    std::vector<DrawnLine> mended = found;
    mended.push_back(squareOutline(3));
    EXPECT_TRUE(missingOf(mended).empty());
}

/// Whole views stay; views without lines get what is missing, if outlines are wanted.
TEST(OutlineCheck, AddsOnlyWhatIsMissing) {
    const laplacian_lines::TriangleMesh cube = cubeOf100();
    SheetOptions options = plainViews("front");
    Observer observer({Object{cube}});
    observer.prepare({options}, {});
    DrawnView drawn = observer.stand(options.views[0], options);
    observer.look(drawn, {}, options, {});
    const std::size_t whole = drawn.lines.size();
    EXPECT_EQ(observer.checkOutlines(drawn, options, pixel), 0);
    EXPECT_EQ(drawn.lines.size(), whole);
    drawn.lines.clear();
    EXPECT_NEAR(observer.checkOutlines(drawn, options, pixel), 400, 4);
    EXPECT_EQ(observer.checkOutlines(drawn, options, pixel), 0);
    for (const auto kind :
         {laplacian_lines::LineKind::Contour, laplacian_lines::LineKind::Border}) {
        SheetOptions without = options;
        without.style.shows[kind] = false;
        drawn.lines.clear();
        EXPECT_EQ(observer.checkOutlines(drawn, without, pixel), 0);
        EXPECT_TRUE(drawn.lines.empty());
    }
}

void expectClosedOutlines(const laplacian_lines::TriangleMesh& mesh, const char* views) {
    SheetOptions options = plainViews(views);
    options.views = parseViews(views, UpAxis::Y);
    options.paper = "fit";
    const Sheet sheet = made_sheets::sheetOf(mesh, options);
    EXPECT_TRUE(sheet.remarks.empty()) << joined(sheet.remarks, " ");
    for (const SheetGroup& group : sheet.groups) {
        if (group.key == "sheet") continue;
        const auto& outlines = layerOf(group, "outline").paths;
        EXPECT_FALSE(outlines.empty()) << group.key;
        for (const SheetPath& path : outlines) {
            const std::vector<Path::Piece>& pieces = path.path.pieces;
            EXPECT_LT((pieces.front().end - pieces.back().end).norm(), 1e-6);
        }
    }
}

/// Faces are seen edge-on.
TEST(Outlines, AreClosedInExactSideViews) {
    expectClosedOutlines(cubeOf100(), "six");
    laplacian_lines::TriangleMesh torus = test_meshes::torus(60, 30).mesh;
    for (Vector3d& p : torus.positions)
        p *= 30;
    expectClosedOutlines(torus, "six");
    expectClosedOutlines(torus, "45,0,30,35");
    expectClosedOutlines(test_meshes::thrown_vessel({150, 180}), "front,top,20,30");
}

/// A line's pen only changes with its class.
TEST(Weights, OfIsoAreTwoToOne) {
    SheetOptions options = plainViews("30,35");
    options.hidden = HiddenLines::Dashed;
    options.pens = pensOf(Weights::Iso);
    const SheetGroup view = made_sheets::sheetOf(cubeOf100(), options).groups[0];
    for (const char* key : {"outline", "edge"}) {
        EXPECT_FALSE(layerOf(view, key).paths.empty()) << key;
        for (const SheetPath& path : layerOf(view, key).paths)
            EXPECT_EQ(path.pen_width, 0.5) << key;
    }
    EXPECT_FALSE(layerOf(view, "hidden").paths.empty());
    for (const SheetPath& path : layerOf(view, "hidden").paths)
        EXPECT_EQ(path.pen_width, 0.25);
}

}  // namespace
