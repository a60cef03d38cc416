// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines are closed and complete; missing parts are found by an independent check.
#include "sight/view_builder.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sheet_helpers.h"

using namespace line_drawing;
using sheet_helpers::cube_of100;
using sheet_helpers::layer_of;
using sheet_helpers::plain_views;

namespace {

constexpr double kPixel = 0.25;

/// Whole views stay; views without lines get what is missing, if outlines are wanted.
TEST(OutlineCheck, AddsOnlyWhatIsMissing) {
    const laplacian_lines::TriangleMesh cube = cube_of100();
    SheetOptions options = plain_views("front");
    ViewBuilder builder({Object{cube}});
    builder.prepare({options}, {});
    DrawnView drawn = builder.empty_view(options.views[0], options);
    builder.add_lines(drawn, {}, options, {});
    const std::size_t whole = drawn.lines.size();
    EXPECT_EQ(builder.check_outlines(drawn, options, kPixel), 0);
    EXPECT_EQ(drawn.lines.size(), whole);
    for (DrawnLine& line : drawn.lines)  // other classes do not count
        line.line_class = LineClass::Contour;
    EXPECT_NEAR(builder.check_outlines(drawn, options, kPixel), 400, 4);
    EXPECT_EQ(builder.check_outlines(drawn, options, kPixel), 0);
    const auto is_left = [](const DrawnLine& line) {
        return line.points[0].position.x() + line.points[1].position.x() < -90;
    };
    drawn.lines.erase(std::remove_if(drawn.lines.begin(), drawn.lines.end(), is_left),
                      drawn.lines.end());
    EXPECT_NEAR(builder.check_outlines(drawn, options, kPixel), 100, 2);
    EXPECT_EQ(builder.check_outlines(drawn, options, kPixel), 0);
    for (const auto kind :
         {laplacian_lines::LineKind::Contour, laplacian_lines::LineKind::Border}) {
        SheetOptions without = options;
        without.style.shows[kind] = false;
        drawn.lines.clear();
        EXPECT_EQ(builder.check_outlines(drawn, without, kPixel), 0);
        EXPECT_TRUE(drawn.lines.empty());
    }
}

void expect_closed_outlines(const laplacian_lines::TriangleMesh& mesh, const char* views) {
    SheetOptions options = plain_views(views);
    options.views = parse_views(views, UpAxis::Y);
    options.paper = "fit";
    const Sheet sheet = sheet_helpers::sheet_of(mesh, options);
    EXPECT_TRUE(sheet.remarks.empty()) << joined(sheet.remarks, " ");
    for (const SheetGroup& group : sheet.groups) {
        if (group.key == "sheet") continue;
        const auto& outlines = layer_of(group, "outline").paths;
        EXPECT_FALSE(outlines.empty()) << group.key;
        for (const SheetPath& path : outlines) {
            const std::vector<Path::Piece>& pieces = path.path.pieces;
            EXPECT_LT((pieces.front().end - pieces.back().end).norm(), 1e-6);
        }
    }
}

/// Faces are seen edge-on.
TEST(Outlines, AreClosedInExactSideViews) {
    expect_closed_outlines(cube_of100(), "six");
    const auto torus = test_meshes::moved(test_meshes::torus(60, 30).mesh, {0, 0, 0}, 30);
    expect_closed_outlines(torus, "six");
    expect_closed_outlines(torus, "45,0,30,35");
    expect_closed_outlines(test_meshes::thrown_vessel({150, 180}), "front,top,20,30");
}

/// A line's pen only changes with its class.
TEST(Weights, OfIsoAreTwoToOne) {
    SheetOptions options = plain_views("30,35");
    options.hidden = HiddenLines::Dashed;
    options.pens = pens_of(Weights::Iso);
    const SheetGroup view = sheet_helpers::sheet_of(cube_of100(), options).groups[0];
    for (const char* key : {"outline", "edge"}) {
        EXPECT_FALSE(layer_of(view, key).paths.empty()) << key;
        for (const SheetPath& path : layer_of(view, key).paths)
            EXPECT_EQ(path.pen_width, 0.5) << key;
    }
    EXPECT_FALSE(layer_of(view, "hidden").paths.empty());
    for (const SheetPath& path : layer_of(view, "hidden").paths)
        EXPECT_EQ(path.pen_width, 0.25);
}

}  // namespace
