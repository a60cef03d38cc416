// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines are closed and whole; missing parts are found by independent means.
#include "sight/observer.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "made_sheets.h"

using namespace line_drawing;
using made_sheets::cubeOf100;
using made_sheets::layerOf;
using made_sheets::plainViews;

namespace {

constexpr double pixel = 0.25;

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
    for (DrawnLine& line : drawn.lines)  // other classes do not count
        line.line_class = LineClass::Contour;
    EXPECT_NEAR(observer.checkOutlines(drawn, options, pixel), 400, 4);
    EXPECT_EQ(observer.checkOutlines(drawn, options, pixel), 0);
    const auto is_left = [](const DrawnLine& line) {
        return line.points[0].position.x() + line.points[1].position.x() < -90;
    };
    drawn.lines.erase(std::remove_if(drawn.lines.begin(), drawn.lines.end(), is_left),
                      drawn.lines.end());
    EXPECT_NEAR(observer.checkOutlines(drawn, options, pixel), 100, 2);
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
    const auto torus = test_meshes::moved(test_meshes::torus(60, 30).mesh, {0, 0, 0}, 30);
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
