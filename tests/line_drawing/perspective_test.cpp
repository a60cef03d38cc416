// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "laplacian_lines/error.h"
#include "made_sheets.h"

using namespace line_drawing;
using Eigen::Vector3d;
using laplacian_lines::TriangleMesh;
using made_sheets::cubeOf100;
using made_sheets::layerOf;
using made_sheets::lengthOf;
using made_sheets::plainViews;
using made_sheets::sheetOf;

namespace {

/// Along -z, from a height.
SheetOptions fromHeight(double z, const char* paper = "a4") {
    SheetOptions options = plainViews("top", paper);
    options.views[0].side = Side::Other;
    options.views[0].name = "View";
    options.views[0].eye = Vector3d(0, 0, z);
    return options;
}

Words textsOf(const Sheet& sheet) {
    Words texts;
    for (const SheetGroup& group : sheet.groups)
        for (const SheetLayer& layer : group.layers)
            for (const SheetText& text : layer.texts)
                texts.push_back(text.text);
    return texts;
}

/// From 150 the near face is twice as large as the far one and hides it with the four edges
/// between.
TEST(Perspective, MakesTheNearFaceOfACubeLarger) {
    SheetOptions options = fromHeight(150);
    options.hidden = HiddenLines::Dashed;
    const SheetGroup view = sheetOf(cubeOf100(), options).groups[0];
    const double near = made_sheets::extentOf(view).width();
    EXPECT_NEAR(near, 190, 0.02);  // the width of A4 without margins
    EXPECT_NEAR(lengthOf(layerOf(view, "outline")), 4 * near, 0.5);
    const double far_face = 4 * near / 2, between = 4 * near / 4 * std::sqrt(2);
    EXPECT_NEAR(lengthOf(layerOf(view, "hidden")), far_face + between, 0.02 * near);
}

TEST(Perspective, HasNoScale) {
    const Sheet sheet = sheetOf(cubeOf100(), fromHeight(150));
    EXPECT_EQ(sheet.scale, 0);
    EXPECT_EQ(sheet.size, Eigen::Vector2d(210, 297));
    EXPECT_NE(joined(textsOf(sheet), "/").find("perspective, not to scale"), std::string::npos);
    for (const SheetLayer& layer : sheet.groups.back().layers)
        EXPECT_NE(layer.key, "scale");
    const Sheet fit = sheetOf(cubeOf100(), fromHeight(150, "fit"));
    EXPECT_NEAR(fit.size.x(), 210, 1e-9);
    EXPECT_LT(fit.size.y(), 297);
}

/// A ball of 40 mm, whose outline is nearer to the eye than its middle.
TEST(Perspective, StandsBesideViewsAtScale) {
    TriangleMesh ball = test_meshes::sphere(5).mesh;
    for (Vector3d& p : ball.positions)
        p *= 40;
    SheetOptions options = fromHeight(100, "a3");
    options.views.insert(options.views.begin(), frameOfSide(Side::Front, UpAxis::Z));
    const Sheet sheet = sheetOf(ball, options);
    EXPECT_EQ(sheet.scale, 1);
    const QRectF front = made_sheets::extentOf(sheet.groups[0]),
                 view = made_sheets::extentOf(sheet.groups[1]);
    EXPECT_NEAR(front.width(), 80, 0.1);
    EXPECT_NEAR(view.width(), 2 * 40 * 100 / std::sqrt(100. * 100 - 40 * 40), 0.1);
    EXPECT_GT(view.top(), front.bottom());
    const Words texts = textsOf(sheet);
    for (const char* name : {"View (perspective, not to scale)", "Front"})
        EXPECT_EQ(std::count(texts.begin(), texts.end(), name), 1) << name;
}

TEST(Perspective, RefusesAnEyeThatSeesNothing) {
    EXPECT_THROW(sheetOf(cubeOf100(), fromHeight(0)), laplacian_lines::Error);
    EXPECT_THROW(sheetOf(cubeOf100(), fromHeight(-200)), laplacian_lines::Error);
}

}  // namespace
