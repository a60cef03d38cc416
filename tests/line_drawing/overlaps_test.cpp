// SPDX-License-Identifier: GPL-3.0-or-later
// Lines that double others go, hooks at ends too; ends meet the lines that they head for.
#include "strokes/strokes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace line_drawing;

namespace {

constexpr double reach = 0.2;

DrawnLine line(LineClass line_class, std::initializer_list<Eigen::Vector2d> positions) {
    DrawnLine result{line_class, false, {}};
    for (const Eigen::Vector2d& p : positions)
        result.points.push_back({p, 1});
    return result;
}

TEST(Overlaps, ALineAlongAnOutlineIsLeftOutThereOnly) {
    const auto rest = withoutDoubles({line(LineClass::Inner, {{0, 5}, {0, 0.1}, {20, 0.1}}),
                                      line(LineClass::Outline, {{-10, 0}, {30, 0}})},
                                     reach);
    ASSERT_EQ(rest.size(), 2u);
    EXPECT_EQ(rest[0].line_class, LineClass::Outline);
    EXPECT_EQ(rest[0].points.size(), 2u);
    EXPECT_EQ(rest[1].points.front().position, Eigen::Vector2d(0, 5));
    EXPECT_LT(rest[1].points.back().position.y(), 0.4);
    EXPECT_LE(rest[1].points.back().position.x(), 2 * reach);
}

TEST(Overlaps, LinesThatCrossOrEndAtOthersStayWhole) {
    const std::vector<DrawnLine> lines = {
        line(LineClass::Outline, {{0, 0}, {20, 0}}), line(LineClass::Inner, {{5, -5}, {5, 5}}),
        line(LineClass::Inner, {{10, 6}, {11, 0}}), line(LineClass::Fine, {{0, 1}, {20, 1}})};
    const auto rest = withoutDoubles(lines, reach);
    ASSERT_EQ(rest.size(), lines.size());
    for (const DrawnLine& l : rest)
        EXPECT_EQ(l.points.size(), 2u);
}

/// The short line between them has doubled the outline.
TEST(Overlaps, EndsMeetTheLinesThatTheyAreBeside) {
    const auto rest = withoutDoubles({line(LineClass::Outline, {{0, 0}, {20, 0}}),
                                      line(LineClass::Edge, {{5, 0.8 * reach}, {5, 10}}),
                                      line(LineClass::Edge, {{8, 3 * reach}, {8, 10}})},
                                     reach);
    ASSERT_EQ(rest.size(), 3u);
    EXPECT_NEAR(rest[1].points.front().position.y(), 0, 1e-9);
    EXPECT_NEAR(rest[2].points.front().position.y(), 3 * reach, 1e-9);
}

/// A step between two edges that end on different lines has no white beside it, but joins them.
/// Also an edge that has passed the line it met, and two that have passed each other, as where a
/// hub's rims are cut into triangles at different places.
TEST(Overlaps, EdgesDoNotGoPastTheirCorners) {
    std::vector<DrawnLine> lines = {line(LineClass::Contour, {{0, 0}, {0, 10.05}}),
                                    line(LineClass::Contour, {{-9, 10}, {0, 10}})};
    joinLooseEnds(lines, {}, reach);
    EXPECT_EQ(lines[0].points.back().position, Eigen::Vector2d(0, 10));
    EXPECT_EQ(lines[0].points.size(), 2u) << "without a way back";
    lines = {line(LineClass::Edge, {{-9, 0}, {0.04, 0.1}}),
             line(LineClass::Edge, {{0, 0}, {9, -0.1}})};
    joinLooseEnds(lines, {}, reach);
    EXPECT_EQ(lines[0].points.back().position, lines[1].points.front().position);
}

/// Short bumps leave no white beside a line; real lines do.
TEST(Overlaps, ShortLinesBesideAnotherAreLeftOut) {
    const DrawnLine outline = line(LineClass::Contour, {{0, 0}, {20, 0}});
    const auto rest_of = [&](const DrawnLine& bump) {
        return withoutDoubles({outline, bump}, reach).size() - 1;
    };
    const double near = 1.3 * reach, far = 2 * reach;
    const auto bump = [](double x, double height) {
        return line(LineClass::Contour, {{5, 0.1}, {5.1, height}, {x, height}, {x + 0.1, 0.1}});
    };
    EXPECT_EQ(rest_of(bump(5.6, near)), 0u);
    EXPECT_EQ(rest_of(bump(5.6, far)), 1u);
    EXPECT_EQ(rest_of(bump(8, near)), 1u);                                             // long
    EXPECT_EQ(rest_of(line(LineClass::Contour, {{20.12, 0.05}, {20.25, 0.05}})), 1u);  // goes on
    // from where another line ends
    EXPECT_EQ(rest_of(line(LineClass::Contour, {{5, near}, {5.5, 0.1}})), 1u);
}

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

}  // namespace
