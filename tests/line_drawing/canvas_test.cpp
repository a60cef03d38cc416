// SPDX-License-Identifier: GPL-3.0-or-later
// What is covered of pixels, by areas and by pens.
#include "pixels/canvas.h"

#include <gtest/gtest.h>

#include <QImage>
#include <cmath>
#include <limits>
#include <random>

using namespace line_drawing;

namespace {

constexpr double pi = 3.14159265358979;

Polygon rectangle(double left, double top, double right, double bottom) {
    return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

Canvas filled(const std::vector<Polygon>& polygons, FillRule rule = FillRule::NonZero) {
    Canvas canvas(10, 8);
    canvas.fill(polygons, rule);
    return canvas;
}

Canvas stroked(const Polygon& line, double width, double dash = 0) {
    std::vector<Polygon> polygons;
    appendStroke(line, width, dash, polygons);
    return filled(polygons);
}

/// Covered pixels, counting parts.
double ink(const Canvas& canvas) {
    double sum = 0;
    for (int y = 0; y < canvas.height(); ++y)
        for (int x = 0; x < canvas.width(); ++x)
            sum += 255 - canvas.row(y)[x];
    return sum / 255;
}

TEST(Canvas, PixelsAreAsDarkAsTheyAreCovered) {
    const Canvas canvas = filled({rectangle(1.5, 2, 4, 3), rectangle(6, 4.5, 7, 5)});
    EXPECT_EQ(canvas.row(2)[0], 255);
    EXPECT_EQ(canvas.row(2)[1], 128);
    EXPECT_EQ(canvas.row(2)[2], 0);
    EXPECT_EQ(canvas.row(2)[4], 255);
    EXPECT_EQ(canvas.row(4)[6], 128);
    EXPECT_EQ(ink(filled({{{1, 1}, {2, 1}, {1, 2}}})), 127. / 255);  // half of a pixel
    EXPECT_NEAR(ink(filled({{{1, 1}, {9, 2}, {5, 7}}})), 22, 0.05);
}

TEST(Canvas, ToneLiesOverWhatIsThere) {
    Canvas canvas = filled({rectangle(0, 0, 4, 4)});
    canvas.fill({rectangle(2, 0, 6, 4)}, FillRule::NonZero, 0.8);
    EXPECT_EQ(canvas.row(1)[1], 0);
    EXPECT_EQ(canvas.row(1)[3], 204);
    EXPECT_EQ(canvas.row(1)[5], 204);
}

TEST(Canvas, RulesSayWhatIsInside) {
    const std::vector<Polygon> nested = {rectangle(1, 1, 7, 7), rectangle(2, 2, 5, 5)};
    EXPECT_DOUBLE_EQ(ink(filled(nested, FillRule::NonZero)), 36);
    EXPECT_DOUBLE_EQ(ink(filled(nested, FillRule::EvenOdd)), 27);
    const Polygon over = rectangle(3.5, 1, 8.5, 7);
    EXPECT_DOUBLE_EQ(ink(filled({over, over})), ink(filled({over})));
}

TEST(Canvas, WhatIsOutsideIsCutOff) {
    EXPECT_DOUBLE_EQ(ink(filled({rectangle(-1e30, -1e30, 1e30, 1e30)})), 80);
    EXPECT_DOUBLE_EQ(ink(filled({rectangle(-5, -5, 2, 3), rectangle(9, 7, 20, 20)})), 7);
    EXPECT_NEAR(ink(filled({{{-1e7, -1e7}, {1e7, 1e7}, {-1e7, 1e7}}})), 32, 0.1);  // below x = y
    for (const double far : {-1e6, 20., 1e300})
        EXPECT_EQ(ink(filled({rectangle(far, far, far + 5, far + 5)})), 0) << far;
    EXPECT_NEAR(ink(stroked({{-1e7, 4}, {1e7, 4}}, 2)), 20, 1e-9);
}

TEST(Canvas, NothingIsDrawnOfNothing) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = HUGE_VAL;
    for (const std::vector<Polygon>& polygons :
         std::vector<std::vector<Polygon>>{{},
                                           {{}},
                                           {{{3, 3}}},
                                           {{{3, 3}, {7, 5}}},
                                           {{{2, 2}, {2, 5}, {2, 3}}},
                                           {{{nan, 1}, {5, 1}, {5, 5}}},
                                           {{{1, 1}, {5, infinity}, {5, 5}}}})
        EXPECT_EQ(ink(filled(polygons)), 0);
    EXPECT_EQ(ink(Canvas(0, 0)), 0);
}

TEST(Pens, HaveRoundEndsAndJoins) {
    EXPECT_NEAR(ink(stroked({{3, 4}, {7, 4}}, 4)), 16 + pi * 4, 0.15);
    EXPECT_NEAR(ink(stroked({{5, 4}, {5, 4}}, 4)), pi * 4, 0.15);  // a dot
    EXPECT_NEAR(ink(stroked({{3, 3}, {7, 3}, {7, 6}}, 2)), 14 - 1 + pi * 1.25, 0.15);
    EXPECT_NEAR(ink(stroked({{3, 4}, {7, 4}, {3, 4}}, 4)), 16 + pi * 4, 0.15);  // there and back
    EXPECT_NEAR(ink(stroked({{3, 4}, {5, 4}, {5, 4}, {7, 4}}, 4)), 16 + pi * 4, 0.15);
}

/// In any direction, with turns.
TEST(Pens, AreAsWideAsTheyAre) {
    for (int degrees = 0; degrees < 360; degrees += 7) {
        const Path::Point way(std::cos(degrees * pi / 180), std::sin(degrees * pi / 180)),
            side(way.y(), -way.x()), middle(5, 4);
        const double expected = 4 * 0.5 + pi * 0.0625;
        EXPECT_NEAR(ink(stroked({middle - 2 * way, middle + 2 * way}, 0.5)), expected, 0.08);
        for (const double turn : {0.01, -0.01})
            EXPECT_NEAR(
                ink(stroked({middle - 2 * way, middle + turn * side, middle + 2 * way}, 0.5)),
                expected, 0.08);
    }
}

TEST(Pens, OfDashesAreCutOff) {
    EXPECT_NEAR(ink(stroked({{0, 4}, {10, 4}}, 2, 2)), 2 * (2 + 2 + 2 + 1), 1e-9);
    EXPECT_NEAR(ink(stroked({{0, 2}, {3, 2}, {3, 7}}, 2, 2)), 2 * (2 + 2 + 2), 0.3);
    for (const Polygon& line : {Polygon{}, Polygon{{5, 4}}, Polygon{{5, 4}, {5, 4}}})
        EXPECT_EQ(ink(stroked(line, 2, 2)), 0);
    EXPECT_EQ(ink(stroked({{5, 4}}, 2)), 0);
    EXPECT_EQ(ink(stroked({{0, 4}, {HUGE_VAL, 4}}, 2, 2)), 0);
}

/// Read by Qt, through zlib.
TEST(PngFiles, HoldEachPixel) {
    std::mt19937 random(1);
    for (const auto& [width, height] : std::vector<std::pair<int, int>>{
             {1, 1}, {3, 2}, {258, 2}, {259, 3}, {263, 2}, {3000, 400}})
        for (const unsigned grays : {1u, 2u, 17u, 256u}) {
            Canvas canvas(width, height);
            for (int i = 0; i < 300; ++i) {
                const double x = random() % unsigned(width), y = random() % unsigned(height);
                canvas.fill({rectangle(x, y, x + random() % 300, y + 1)}, FillRule::NonZero,
                            grays > 1 ? (random() % grays) / (grays - 1.) : 0);
            }
            const QImage image = QImage::fromData(QByteArray::fromStdString(inPng(canvas, 5000)));
            ASSERT_EQ(image.size(), QSize(width, height));
            ASSERT_EQ(image.format(), QImage::Format_Grayscale8);
            ASSERT_EQ(image.dotsPerMeterX(), 5000);
            for (int y = 0; y < height; ++y)
                ASSERT_TRUE(std::equal(canvas.row(y), canvas.row(y) + width, image.scanLine(y)));
        }
}

/// Each gray is half as frequent as the one before: unlimited codes would be too long.
TEST(PngFiles, HaveNoCodeThatIsTooLong) {
    Canvas canvas(1 << 19, 4);
    double begin = 0;
    for (int gray = 0; gray < 20; ++gray) {
        std::vector<Polygon> pixels;
        for (int i = 0; i < 1 << gray; ++i, begin += 2) {
            const double x = std::fmod(begin, canvas.width()),
                         y = std::floor(begin / canvas.width());
            pixels.push_back(rectangle(x, y, x + 1, y + 1));
        }
        canvas.fill(pixels, FillRule::NonZero, gray / 255.);
    }
    const QImage image = QImage::fromData(QByteArray::fromStdString(inPng(canvas, 5000)));
    ASSERT_EQ(image.width(), canvas.width());
    for (int y = 0; y < 4; ++y)
        EXPECT_TRUE(std::equal(canvas.row(y), canvas.row(y) + canvas.width(), image.scanLine(y)));
}

}  // namespace
