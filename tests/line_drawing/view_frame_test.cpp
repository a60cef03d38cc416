// SPDX-License-Identifier: GPL-3.0-or-later
// Views and their names; perspective ones.
#include "line_drawing/view_frame.h"

#include <gtest/gtest.h>

#include <cmath>

#include "laplacian_lines/error.h"
#include "sheet_helpers.h"

using namespace line_drawing;
using Eigen::Vector3d;
using sheet_helpers::cube_of100;
using sheet_helpers::layer_of;
using sheet_helpers::length_of;
using sheet_helpers::plain_views;
using sheet_helpers::sheet_of;
using sheet_helpers::texts_of;

namespace {

constexpr UpAxis kAllAxes[] = {UpAxis::X, UpAxis::Y, UpAxis::Z};

void expect_right_handed(const ViewFrame& frame) {
    EXPECT_NEAR(frame.right.norm(), 1, 1e-12) << frame.name;
    EXPECT_NEAR(frame.up.norm(), 1, 1e-12) << frame.name;
    EXPECT_LT((frame.right.cross(frame.up) - frame.towards_viewer).norm(), 1e-12) << frame.name;
}

TEST(ViewFrames, AreRightHanded) {
    for (const UpAxis up : kAllAxes)
        for (const ViewFrame& frame : parse_views("six 0,90 30,15 -120,-90", up))
            expect_right_handed(frame);
}

TEST(ViewFrames, OfAnUprightZ) {
    const ViewFrame front = frame_of_side(Side::Front, UpAxis::Z);
    EXPECT_EQ(front.right, Vector3d(1, 0, 0));
    EXPECT_EQ(front.up, Vector3d(0, 0, 1));
    EXPECT_EQ(frame_of_side(Side::Left, UpAxis::Z).towards_viewer, Vector3d(-1, 0, 0));
    EXPECT_EQ(frame_of_side(Side::Top, UpAxis::Z).up, Vector3d(0, 1, 0));
    EXPECT_EQ(frame_of_side(Side::Bottom, UpAxis::Z).up, Vector3d(0, -1, 0));
}

TEST(ViewFrames, DirectionsMeetTheSides) {
    const auto distance = [](const ViewFrame& a, const ViewFrame& b) {
        return (a.right - b.right).norm() + (a.up - b.up).norm();
    };
    for (const UpAxis up : kAllAxes) {
        EXPECT_LT(distance(frame_of_direction(90, 0, up), frame_of_side(Side::Right, up)), 1e-12);
        EXPECT_LT(distance(frame_of_direction(-90, 0, up), frame_of_side(Side::Left, up)), 1e-12);
        EXPECT_LT(distance(frame_of_direction(180, 0, up), frame_of_side(Side::Back, up)), 1e-12);
        EXPECT_LT(distance(frame_of_direction(0, 90, up), frame_of_side(Side::Top, up)), 1e-12);
        EXPECT_LT(distance(frame_of_direction(0, -90, up), frame_of_side(Side::Bottom, up)), 1e-12);
    }
}

TEST(ViewFrames, TellWhereADirectionOfThePictureLeads) {
    const ViewFrame left = frame_of_side(Side::Left, UpAxis::Z);  // x of the picture is -y
    EXPECT_EQ(in_mesh(Vector3d(1, 2, 3), left), Vector3d(-3, -1, 2));
}

TEST(ViewFrames, AreNamed) {
    const std::vector<ViewFrame> views = parse_views("front, Top;30,-15 left", UpAxis::Z);
    ASSERT_EQ(views.size(), 4u);
    EXPECT_EQ(views[0].name, "Front");
    EXPECT_EQ(views[1].side, Side::Top);
    EXPECT_EQ(views[2].name, "View 30°, -15°");
    EXPECT_EQ(views[3].side, Side::Left);
    EXPECT_EQ(parse_views("six", UpAxis::Z).size(), 6u);
}

TEST(ViewFrames, MayHaveNamesOfAProgram) {
    const NamedViews others = {{"window", frame_of_direction(10, 20, UpAxis::Z)}};
    const std::vector<ViewFrame> views = parse_views("top,Window 30,15", UpAxis::Z, others);
    ASSERT_EQ(views.size(), 3u);
    EXPECT_EQ(views[1].name, "View 10°, 20°");
    EXPECT_EQ(views[2].name, "View 30°, 15°");
    EXPECT_THROW(parse_views("30,window", UpAxis::Z, others), laplacian_lines::Error);
}

TEST(ViewFrames, AreReadFromTheirWords) {
    ViewFrame frame = frame_of_direction(10, 20, UpAxis::X);
    for (const bool has_eye : {false, true}) {
        if (has_eye) frame.eye = Vector3d(1, -2.5, 1e7);
        const ViewFrame read = parse_views("top, " + frame_text(frame), UpAxis::Z).back();
        EXPECT_LT((read.right - frame.right).norm() + (read.up - frame.up).norm(), 1e-7);
        EXPECT_EQ(read.eye, frame.eye);
    }
    for (const char* words : {"toward", "toward 1 0 0 0 1", "toward 1 0 0 2 0 0",
                              "toward .1 .2 .3 .3 .6 .9", "toward 0 0 0 0 1 0"})
        EXPECT_THROW(parse_views(words, UpAxis::Z), laplacian_lines::Error) << words;
}

TEST(ViewFrames, OfOtherWordsAreRefused) {
    for (const char* words : {"", "above", "30", "30,left", "0,91", "front,nan,0"})
        EXPECT_THROW(parse_views(words, UpAxis::Z), laplacian_lines::Error) << words;
}

/// Along -z, from a height.
SheetOptions from_height(double z, const char* paper = "a4") {
    SheetOptions options = plain_views("top", paper);
    options.views[0].side = Side::Other;
    options.views[0].name = "View";
    options.views[0].eye = Vector3d(0, 0, z);
    return options;
}

/// From 150 the near face is twice as large as the far one and hides it with the four edges
/// between.
TEST(Perspective, MakesTheNearFaceOfACubeLarger) {
    SheetOptions options = from_height(150);
    options.hidden = HiddenLines::Dashed;
    const SheetGroup view = sheet_of(cube_of100(), options).groups[0];
    const double near = sheet_helpers::extent_of(view).width();
    EXPECT_NEAR(near, 190, 0.02);  // the width of A4 without margins
    EXPECT_NEAR(length_of(layer_of(view, "outline")), 4 * near, 0.5);
    const double far_face = 4 * near / 2, between = 4 * near / 4 * std::sqrt(2);
    EXPECT_NEAR(length_of(layer_of(view, "hidden")), far_face + between, 0.02 * near);
}

TEST(Perspective, HasNoScale) {
    const Sheet sheet = sheet_of(cube_of100(), from_height(150));
    EXPECT_EQ(sheet.scale, 0);
    EXPECT_EQ(sheet.size, Eigen::Vector2d(210, 297));
    EXPECT_TRUE(sheet_helpers::has(joined(texts_of(sheet), "/"), "perspective, not to scale"));
    for (const SheetLayer& layer : sheet.groups.back().layers)
        EXPECT_NE(layer.key, "scale");
    const Sheet fit = sheet_of(cube_of100(), from_height(150, "fit"));
    EXPECT_NEAR(fit.size.x(), 210, 1e-9);
    EXPECT_LT(fit.size.y(), 297);
}

/// A ball of radius 40 mm, whose outline is nearer to the eye than its middle.
TEST(Perspective, StandsBesideViewsAtScale) {
    const auto ball = test_meshes::sphere(5, 40).mesh;
    SheetOptions options = from_height(100, "a3");
    options.views.insert(options.views.begin(), frame_of_side(Side::Front, UpAxis::Z));
    const Sheet sheet = sheet_of(ball, options);
    EXPECT_EQ(sheet.scale, 1);
    const QRectF front = sheet_helpers::extent_of(sheet.groups[0]),
                 view = sheet_helpers::extent_of(sheet.groups[1]);
    EXPECT_NEAR(front.width(), 80, 0.1);
    EXPECT_NEAR(view.width(), 2 * 40 * 100 / std::sqrt(100. * 100 - 40 * 40), 0.1);
    EXPECT_GT(view.top(), front.bottom());
    const Words texts = texts_of(sheet);
    for (const char* name : {"View (perspective, not to scale)", "Front"})
        EXPECT_EQ(std::count(texts.begin(), texts.end(), name), 1) << name;
}

TEST(Perspective, MayBeFromTheVeryMiddleOfARing) {
    SheetOptions options = plain_views("front", "a4");
    options.views[0].eye = Vector3d(0, 0, 0);
    EXPECT_NO_THROW(sheet_of(test_meshes::torus(60, 32).mesh, options));
}

TEST(Perspective, RefusesAnEyeThatSeesNothing) {
    EXPECT_THROW(sheet_of(cube_of100(), from_height(0)), laplacian_lines::Error);
    EXPECT_THROW(sheet_of(cube_of100(), from_height(-200)), laplacian_lines::Error);
}

}  // namespace
