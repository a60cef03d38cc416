// SPDX-License-Identifier: GPL-3.0-or-later
// Visible lines: width, colors, joints and ends, in pixels.
#include <algorithm>
#include <cmath>

#include "gl_test.h"

namespace {

using Eigen::Vector3f;
using laplacian_lines::LineKind;
using laplacian_lines::LineSet;
using line_renderer::LineAppearance;

const LineSet kHorizontal = one_line({{20, 60.3f, 0}, {70, 60.3f, 0}, {140, 60.3f, 0}});
const LineSet kOblique = one_line({{20, 20, 0}, {140, 90, 0}});

/// Mean width over columns 40 to 119 of a black line of this slope, pixels.
double width_in(const QImage& picture, double slope) {
    double ink = 0;
    for (int x = 40; x < 120; ++x)
        ink += ink_of_column(picture, x);
    return ink / 80 / std::sqrt(1 + slope * slope);
}

TEST_F(LineTest, AreAsWideAsAsked) {
    for (double width : {1.0, 1.6, 2.0, 3.5, 6.0, 9.0}) {
        canvas_.clear();
        EXPECT_NEAR(width_in(drawn(kHorizontal, black_lines(width)), 0), width, 0.03);
        canvas_.clear();
        EXPECT_NEAR(width_in(drawn(kOblique, black_lines(width)), 70.0 / 120), width, 0.05);
    }
}

TEST_F(LineTest, GrowWithThePixelsOfTheViewport) {
    line_renderer::LinePlacement placement = Canvas::placement();
    placement.pixel_scale = 2.5;
    EXPECT_NEAR(width_in(drawn(kHorizontal, black_lines(2), placement), 0), 5, 0.03);
}

/// At weight 0 they keep 0.35 of their width.
TEST_F(LineTest, TaperWithTheirWeight) {
    LineSet line = one_line({{20, 60.3f, 0}, {140, 60.3f, 0}});
    line.points[0].weight = 0;
    const QImage picture = drawn(line, black_lines(8));
    for (int x : {30, 80, 130})
        EXPECT_NEAR(ink_of_column(picture, x), 8 * (0.35 + 0.65 * (x + 0.5 - 20) / 120), 0.1) << x;
}

TEST_F(LineTest, HaveTheLookOfTheirKind) {
    LineSet lines;
    LineAppearance appearance;
    const int rows = Canvas::height / int(laplacian_lines::kLineKindCount);  // for each
    for (std::size_t i = 0; i < laplacian_lines::kLineKindCount; ++i) {
        const float y = float(rows * int(i) + rows / 2) + 0.5f;
        add_line(lines, {{20, y, 0}, {140, y, 0}}, LineKind(i));
        const QColor color = QColor::fromHsv(int(70 * i) % 360, 200, 250 - int(10 * i));
        appearance.looks[i] = {color.rgb(), 3 + 2 * double(i % 2)};
    }
    const QImage picture = drawn(lines, appearance);
    for (std::size_t i = 0; i < laplacian_lines::kLineKindCount; ++i) {
        const int y = rows * int(i) + rows / 2, reach = 1 + int(i % 2);
        for (int row : {y - reach, y, y + reach})
            EXPECT_EQ(color_at(picture, 80, row), appearance.looks[i].color) << "kind " << i;
        for (int row : {y - reach - 1, y + reach + 1})
            EXPECT_EQ(color_at(picture, 80, row), QColor(Qt::white)) << "kind " << i;
    }
}

TEST_F(LineTest, BlendByOpacityAndTheAlphaOfTheirColor) {
    LineSet lines;
    add_line(lines, {{20, 30.5f, 0}, {140, 30.5f, 0}}, LineKind::Laplacian, false, 0.25f);
    add_line(lines, {{20, 80.5f, 0}, {140, 80.5f, 0}}, LineKind::Contour);
    LineAppearance appearance = black_lines(5);
    appearance.looks[std::size_t(LineKind::Contour)].color = QColor(0, 0, 0, 102);
    const QImage picture = drawn(lines, appearance);
    EXPECT_NEAR(color_at(picture, 80, 30).greenF(), 0.75, 0.005);
    EXPECT_NEAR(color_at(picture, 80, 80).greenF(), 0.6, 0.005);
}

/// Pixels painted twice would differ in color, at joints up to a right angle and at the start of
/// closed lines.
TEST_F(LineTest, AreOfOneTone) {
    LineSet lines;
    add_line(lines, {{20, 20, 0}, {60, 50, 0}, {65, 90, 0}, {95, 95, 0}});
    add_line(lines,
             {{112, 38, 0}, {125, 25, 0}, {145, 40, 0}, {145, 55, 0}, {128, 62, 0}, {112, 38, 0}},
             LineKind::Contour, true);
    LineAppearance appearance;
    appearance.looks.fill({QColor(0, 0, 0, 102), 6});
    const QImage picture = drawn(lines, appearance);
    double darkest = 1;
    for (int x = 0; x < Canvas::width; ++x)
        for (int y = 0; y < Canvas::height; ++y)
            darkest = std::min(darkest, color_at(picture, x, y).greenF());
    EXPECT_NEAR(darkest, 0.6, 0.005);
    for (const auto& point : lines.points)
        EXPECT_LT(color_at(picture, int(point.position.x()), int(point.position.y())).greenF(), 0.9)
            << "a gap at " << point.position.transpose();
}

/// A line that turns back has its full width in each column, as far as it goes.
TEST_F(LineTest, KeepTheirWidthWhereTheyTurnBack) {
    for (const float aside : {0.f, 0.4f, 1.f, 3.f}) {
        canvas_.clear();
        const LineSet line = one_line({{20, 60.5f, 0}, {140, 60.5f, 0}, {110, 60.5f + aside, 0}});
        const QImage picture = drawn(line, black_lines(6));
        for (int x = 30; x < 105; ++x)
            EXPECT_NEAR(ink_of_column(picture, x), 6, 0.05) << aside << " aside, column " << x;
        for (int x = 112; x < 138; ++x)
            EXPECT_GE(ink_of_column(picture, x), 5.95) << aside << " aside, column " << x;
    }
}

/// Points a tenth of a pixel apart, of which the tolerance drops some.
TEST_F(LineTest, LookTheSameWithoutThePointsThatAreNotSeen) {
    LineSet lines;
    for (int i = 0; i < 5; ++i) {
        std::vector<Vector3f> wave;
        for (float x = 10; x < 150; x += 0.1f)
            wave.push_back({x, 15 + 20 * float(i) + 6 * std::sin(0.1f * x * float(i + 1)), 0});
        add_line(lines, wave);
        for (std::size_t k = lines.points.size() - wave.size(); k < lines.points.size(); ++k)
            lines.points[k].weight = std::abs(std::sin(0.03f * lines.points[k].position.x()));
    }
    line_renderer::LinePlacement placement = Canvas::placement();
    placement.tolerance = 0;
    const QImage all = drawn(lines, black_lines(2.5), placement);
    canvas_.clear();
    const QImage simplified = drawn(lines, black_lines(2.5));
    EXPECT_NEAR(ink_of(simplified), ink_of(all), 0.02 * ink_of(all));
    double greatest = 0;
    for (int x = 0; x < Canvas::width; ++x)
        for (int y = 0; y < Canvas::height; ++y)
            greatest = std::max(greatest, std::abs(color_at(simplified, x, y).greenF() -
                                                   color_at(all, x, y).greenF()));
    EXPECT_GT(greatest, 0) << "nothing was left out";
    EXPECT_LT(greatest, 0.3);
}

TEST_F(LineTest, AreOpaqueWhereThePictureIsNot) {
    canvas_.clear(0);
    const QImage picture = drawn(kHorizontal, black_lines(5));
    EXPECT_EQ(color_at(picture, 80, 60).alpha(), 255);
    EXPECT_EQ(color_at(picture, 80, 20).alpha(), 0);
}

/// More, fewer, or none.
TEST_F(LineTest, AreThoseHandedOverLast) {
    const LineAppearance appearance = black_lines(3);
    const double one = ink_of(drawn(kHorizontal, appearance));
    LineSet many;
    for (int i = 0; i < 20; ++i) {
        const float y = 5.3f + 5 * float(i);
        add_line(many, {{20, y, 0}, {70, y, 0}, {140, y, 0}});
    }
    canvas_.clear();
    EXPECT_NEAR(ink_of(drawn(many, appearance)), 20 * one, 1);
    canvas_.clear();
    EXPECT_NEAR(ink_of(drawn(kHorizontal, appearance)), one, 0.01);
    canvas_.clear();
    EXPECT_EQ(ink_of(drawn(LineSet(), appearance)), 0);
}

/// With the camera inside the scene lines are clipped, not flipped.
TEST_F(LineTest, EndAtTheNearPlaneOfAPerspectiveView) {
    line_renderer::LinePlacement placement = Canvas::placement();
    placement.projection << 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1.02, -0.202, 0, 0, -1, 0;
    const QImage picture =
        drawn(one_line({{-0.5f, 0, -1}, {1.5f, 0, 1}}), black_lines(4), placement);
    EXPECT_NEAR(ink_of_column(picture, 60), 4, 0.05) << "before the eye, to the left";
    EXPECT_EQ(ink_of_column(picture, 20), 0);
    EXPECT_NEAR(ink_of_column(picture, 150), 4, 0.05) << "to the near plane, far to the right";
}

}  // namespace
