// SPDX-License-Identifier: GPL-3.0-or-later
// Hooks at ends of inner lines are removed; ends that head for a line meet it.
#include "strokes/strokes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace line_drawing;

namespace {

constexpr double pen = 0.25;

/// 10 mm along x, then `length` at `degrees`, in steps of .1 mm.
DrawnLine hooked(double length, double degrees) {
    DrawnLine line{LineClass::Inner, false, {}};
    const double angle = degrees * 3.141592653589793 / 180;
    for (int i = 0; i <= 100; ++i)
        line.points.push_back({{0.1 * i, 0}});
    for (double at = 0.1; at < length + 0.05; at += 0.1)
        line.points.push_back({{10 + at * std::cos(angle), at * std::sin(angle)}});
    for (DrawnPoint& point : line.points)
        point.is_exact = false;
    return line;
}

double lengthWithoutHooks(std::vector<DrawnLine> lines) {
    cutHooks(lines, pen);
    return lengthOf(lines[0].points);
}

TEST(EndHooks, AreCutAtBothEnds) {
    DrawnLine line = hooked(1, 100);
    EXPECT_NEAR(lengthWithoutHooks({line}), 10, pen);
    std::reverse(line.points.begin(), line.points.end());
    EXPECT_NEAR(lengthWithoutHooks({line}), 10, pen);
}

TEST(EndHooks, AreNoBendsOfTheFeature) {
    EXPECT_NEAR(lengthWithoutHooks({hooked(1, 40)}), 11, 1e-6);   // slight
    EXPECT_NEAR(lengthWithoutHooks({hooked(5, 100)}), 15, 1e-6);  // long
}

TEST(EndHooks, StayWhereTheyMeetALine) {
    const DrawnLine line = hooked(1, 90);
    const DrawnLine met{LineClass::Contour, false, {{{5, 1}}, {{15, 1}}}};
    EXPECT_NEAR(lengthWithoutHooks({line, met}), 11, 1e-6);
}

/// Along x to 10 mm, in steps of .1, towards an outline across the axis at `x`.
std::vector<DrawnLine> headingFor(double x, double weight = 1) {
    DrawnLine line = hooked(0, 0);
    for (DrawnPoint& point : line.points)
        point.weight = weight;
    return {line, {LineClass::Outline, false, {{{x, -5}}, {{x, 5}}}}};
}

TEST(InnerEnds, AreLedToTheLineThatTheyHeadFor) {
    std::vector<DrawnLine> lines = headingFor(10.7);
    const std::vector<MetEnd> met = joinEnds(lines, pen);
    ASSERT_EQ(met.size(), 1u);
    EXPECT_TRUE(met[0].is_last);
    EXPECT_EQ(met[0].met, 1u);
    EXPECT_NEAR(lines[0].points.back().position.x(), 10.7, 1e-9);
    EXPECT_EQ(lines[0].points.front().position.x(), 0);
}

TEST(InnerEnds, StayWhereNothingIsMet) {
    std::vector<DrawnLine> far = headingFor(10.8), faint = headingFor(10.7, 0.4),
                           aside = headingFor(10.7);
    aside[1].points = {{{0, 0.6}}, {{20, 0.6}}};
    for (auto* lines : {&far, &faint, &aside}) {
        EXPECT_TRUE(joinEnds(*lines, pen).empty());
        EXPECT_EQ((*lines)[0].points.back().position.x(), 10);
    }
}

TEST(InnerEnds, FollowTheLineThatTheyMeet) {
    std::vector<DrawnLine> lines = headingFor(10.05);
    const std::vector<MetEnd> met = joinEnds(lines, pen);
    ASSERT_EQ(met.size(), 1u);
    for (DrawnPoint& point : lines[1].points)
        point.position.x() += 0.1;
    followMet(met, pen, lines);
    EXPECT_NEAR(lines[0].points.back().position.x(), 10.15, 1e-9);
    EXPECT_EQ(lines[0].points[80].position.x(), 8);  // beyond four pens
    for (std::size_t i = 81; i < lines[0].points.size(); ++i)
        EXPECT_GT(lines[0].points[i].position.x(), lines[0].points[i - 1].position.x());
}

}  // namespace
