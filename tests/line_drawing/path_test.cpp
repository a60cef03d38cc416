// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/path.h"

#include <gtest/gtest.h>

#include <random>

#include "line_drawing/words.h"

using Eigen::Vector2d;
using namespace line_drawing;

namespace {

Vector2d pointAt(double t, const Vector2d& begin, const Path::Piece& curve) {
    const double s = 1 - t;
    return s * s * s * begin + 3 * s * s * t * curve.first + 3 * s * t * t * curve.second +
           t * t * t * curve.end;
}

TEST(Paths, BoundsAndPointsAreThoseOfCurves) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-10, 10);
    const auto next = [&] { return Vector2d(place(random), place(random)); };
    constexpr double tolerance = 0.01;
    constexpr int steps = 2000;
    for (int round = 0; round < 200; ++round) {
        Path path;
        path.moveTo(next());
        path.curveTo(next(), next(), next());
        const auto line = path.flattened(tolerance).at(0);
        Eigen::AlignedBox2d box;
        for (int i = 0; i <= steps; ++i) {
            const Vector2d p = pointAt(i / double(steps), path.pieces[0].end, path.pieces[1]);
            box.extend(p);
            double least = INFINITY;
            for (std::size_t k = 1; k < line.size(); ++k) {
                const Vector2d way = line[k] - line[k - 1];
                const double t = std::clamp(way.dot(p - line[k - 1]) / way.squaredNorm(), 0., 1.);
                least = std::min(least, (line[k - 1] + t * way - p).norm());
            }
            ASSERT_LT(least, tolerance) << round;
        }
        EXPECT_LT((box.min() - path.bounds().min()).norm(), 1e-3) << round;
        EXPECT_LT((box.max() - path.bounds().max()).norm(), 1e-3) << round;
    }
}

TEST(Texts, AreReadAsUtf8WhateverTheyHold) {
    EXPECT_EQ(lettersOf("a\xc3\xbc\xe2\x88\x9a\xf0\x9f\x98\x80"), U"a\u00fc\u221a\U0001f600");
    // cut off, too long, half of a pair, no beginning
    for (const char* wrong :
         {"\xc3", "\xe2\x88", "\xc0\x80", "\xe0\x80\x80", "\xed\xa0\x80", "\x88"})
        EXPECT_EQ(lettersOf(wrong), std::u32string(std::string(wrong).size(), U'\ufffd')) << wrong;
    EXPECT_EQ(inUtf8(lettersOf("\xf0\x9f\x98\x80 \xc3\xa9")), "\xf0\x9f\x98\x80 \xc3\xa9");
    EXPECT_EQ(oneLine("a\x7f\xc2\x85\xe2\x80\xa9"
                      "b"),
              "a   b");
}

TEST(Texts, AreNumbersOrNot) {
    for (const char* number : {"0.5", " .5 ", "+0.5", "5e-1"})
        EXPECT_EQ(numberIn(number), 0.5) << number;
    for (const char* none : {"", " ", "+", "+-1", "1,5", "1 2", "0x1", "1e999"})
        EXPECT_FALSE(numberIn(none)) << none;
    EXPECT_EQ(inThousandths(-0.0496), "-.05");
    EXPECT_EQ(inThousandths(0.0004), "0");
    EXPECT_EQ(inThousandths(120), "120");
    EXPECT_EQ(inDigits(1e6), "1e+06");
}

}  // namespace
