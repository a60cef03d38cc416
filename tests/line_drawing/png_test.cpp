// SPDX-License-Identifier: GPL-3.0-or-later
// What is covered of pixels, by areas and by pens.
#include <gtest/gtest.h>

#include <QImage>
#include <cmath>

#include "line_drawing/sheet_file.h"

using namespace line_drawing;
using Points = std::vector<Path::Point>;

namespace {

Path path_of(const Points& points, bool is_closed) {
    Path path;
    path.fill_rule = FillRule::NonZero;
    for (const Path::Point& p : points)
        &p == points.data() ? path.move_to(p) : path.line_to(p);
    if (is_closed) path.close();
    return path;
}

Points rectangle(double left, double top, double right, double bottom) {
    return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

/// 10 x 8 pixels of a millimetre.
QImage picture_of(const std::vector<SheetPath>& paths) {
    const Sheet sheet{{10, 8}, "", {{"a", "A", {{"outline", "Outlines", paths, {}}}}}, 1};
    return QImage::fromData(QByteArray::fromStdString(write_sheet(sheet, ".png", 25.4)));
}

QImage filled(const Points& points, double tone = 0) {
    return picture_of({{path_of(points, true), 0, 0, tone}});
}

QImage stroked(const Points& line, double width, double dash = 0) {
    return picture_of({{path_of(line, false), width, dash}});
}

int gray(const QImage& image, int x, int y) {
    return qGray(image.pixel(x, y));
}

/// Covered pixels, counting parts.
double ink(const QImage& image) {
    double sum = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            sum += 255 - gray(image, x, y);
    return sum / 255;
}

TEST(PngFiles, HavePixelsAsDarkAsTheyAreCovered) {
    const QImage image = filled(rectangle(1.5, 2, 4, 2.5));
    EXPECT_EQ(image.size(), QSize(10, 8));
    EXPECT_EQ(gray(image, 0, 2), 255);
    EXPECT_EQ(gray(image, 1, 2), 191);
    EXPECT_EQ(gray(image, 2, 2), 128);
    EXPECT_EQ(gray(image, 4, 2), 255);
    EXPECT_NEAR(ink(filled({{1, 1}, {9, 2}, {5, 7}})), 22, 0.05);
    EXPECT_EQ(gray(filled(rectangle(0, 0, 4, 4), 0.8), 1, 1), 204);
}

TEST(PngFiles, FollowTheRuleOfWhatIsInside) {
    for (const FillRule rule : {FillRule::NonZero, FillRule::EvenOdd}) {
        Path nested = path_of(rectangle(1, 1, 7, 7), true);
        nested.add_rectangle({2, 2}, 3, 3);
        nested.fill_rule = rule;
        EXPECT_DOUBLE_EQ(ink(picture_of({{nested}})), rule == FillRule::NonZero ? 36 : 27);
    }
}

TEST(PngFiles, CutOffWhatIsOutside) {
    EXPECT_DOUBLE_EQ(ink(filled(rectangle(-1e30, -1e30, 1e30, 1e30))), 80);
    EXPECT_DOUBLE_EQ(ink(filled(rectangle(-5, -5, 2, 3))), 6);
    EXPECT_EQ(ink(filled(rectangle(20, 20, 30, 30))), 0);
    EXPECT_NEAR(ink(stroked({{-1e7, 4}, {1e7, 4}}, 2)), 20, 1e-9);
    EXPECT_EQ(ink(filled({{1, 1}, {5, HUGE_VAL}, {5, 5}})), 0);
}

TEST(PngFiles, HavePensWithRoundEndsAndJoins) {
    EXPECT_NEAR(ink(stroked({{3, 4}, {7, 4}}, 4)), 16 + M_PI * 4, 0.15);
    EXPECT_NEAR(ink(stroked({{3, 3}, {7, 3}, {7, 6}}, 2)), 14 - 1 + M_PI * 1.25, 0.15);
    EXPECT_NEAR(ink(stroked({{3, 4}, {7, 4}, {3, 4}}, 4)), 16 + M_PI * 4, 0.15);  // there and back
    for (int degrees = 0; degrees < 360; degrees += 35) {
        const Path::Point middle(5, 4),
            span(2 * std::cos(degrees * M_PI / 180), 2 * std::sin(degrees * M_PI / 180));
        EXPECT_NEAR(ink(stroked({middle - span, middle + span}, 0.5)), 4 * 0.5 + M_PI * 0.0625,
                    0.08);
    }
}

TEST(PngFiles, CutOffDashes) {
    EXPECT_NEAR(ink(stroked({{0, 4}, {10, 4}}, 2, 2)), 2 * (2 + 2 + 2 + 1), 1e-9);
    EXPECT_NEAR(ink(stroked({{0, 2}, {3, 2}, {3, 7}}, 2, 2)), 2 * (2 + 2 + 2), 0.3);
}

}  // namespace
