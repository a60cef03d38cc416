// SPDX-License-Identifier: GPL-3.0-or-later
// Lines are smoothed within a part of their pen; specks go.
#include "strokes/line_easing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "strokes/strokes.h"

using namespace line_drawing;
using Eigen::Vector2d;

namespace {

constexpr double reach = 0.12;

/// Across the x axis by `height`, every half millimetre or so.
DrawnLine zigzag(double height, int points, bool is_exact = false, double spacing = 0.5) {
    DrawnLine line{LineClass::Contour, false, {}};
    for (int i = 0; i < points; ++i)
        line.points.push_back({{spacing * i, i % 2 ? height : 0}, 1, std::uint32_t(i), is_exact});
    line.points.front().is_exact = line.points.back().is_exact = true;
    return line;
}

double turning(const DrawnLine& line) {
    double sum = 0;
    for (std::size_t i = 2; i < line.points.size(); ++i) {
        const Vector2d a = line.points[i - 1].position - line.points[i - 2].position,
                       b = line.points[i].position - line.points[i - 1].position;
        sum += std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
    }
    return sum;
}

double distanceTo(const DrawnLine& line, const Vector2d& p) {
    double least = INFINITY;
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        const Vector2d &a = line.points[i - 1].position, way = line.points[i].position - a;
        const double t = std::clamp(way.dot(p - a) / way.squaredNorm(), 0., 1.);
        least = std::min(least, (a + t * way - p).norm());
    }
    return least;
}

TEST(LineEasing, TakesTheTurnsOutAndStaysWithinReach) {
    const DrawnLine before = zigzag(0.1, 41);
    std::vector<DrawnLine> lines = {before};
    easeLines(lines, reach);
    EXPECT_LT(turning(lines[0]), 0.1 * turning(before));
    for (const DrawnPoint& point : lines[0].points)
        EXPECT_LE(distanceTo(before, point.position), reach + 1e-9);
    EXPECT_EQ(lines[0].points.front().position, before.points.front().position);
    EXPECT_EQ(lines[0].points.back().position, before.points.back().position);
}

/// Beyond the reach.
TEST(LineEasing, KeepsWhatIsLarge) {
    const DrawnLine before = zigzag(3, 41);
    std::vector<DrawnLine> lines = {before};
    easeLines(lines, reach);
    for (const DrawnPoint& point : before.points)
        EXPECT_LE(distanceTo(lines[0], point.position), 3 * reach);
}

TEST(LineEasing, KeepsEdgesOfTheForm) {
    const DrawnLine before = zigzag(0.1, 41, true);
    std::vector<DrawnLine> lines = {before};
    easeLines(lines, reach);
    ASSERT_EQ(lines[0].points.size(), before.points.size());
    for (std::size_t i = 0; i < before.points.size(); ++i)
        EXPECT_EQ(lines[0].points[i].position, before.points[i].position);
}

TEST(LineEasing, HasEndsFollow) {
    const DrawnLine contour = zigzag(0.1, 41);
    const DrawnLine edge{
        LineClass::Edge, false, {{{10.5, 8}}, {contour.points[21].position, 1, 21, true}}};
    std::vector<DrawnLine> lines = {edge, contour};
    easeLines(lines, reach);
    EXPECT_GT((lines[0].points.back().position - contour.points[21].position).norm(), 0.02);
    EXPECT_LT(distanceTo(lines[1], lines[0].points.back().position), 0.01);
    EXPECT_EQ(lines[0].points.front().position, edge.points.front().position);
}

/// Degrees.
double sharpest(const DrawnLine& line) {
    double largest = 0;
    for (std::size_t i = 2; i < line.points.size(); ++i) {
        const DrawnLine part{line.line_class,
                             false,
                             {line.points.begin() + std::ptrdiff_t(i) - 2,
                              line.points.begin() + std::ptrdiff_t(i) + 1}};
        largest = std::max(largest, turning(part));
    }
    return largest * 180 / 3.141592653589793;
}

/// Waves too high to smooth away, with a corner each: what bends least touches its tube smoothly,
/// what is shortest would not.
TEST(LineEasing, LeavesNoCorners) {
    const DrawnLine before = zigzag(1.2, 41, false, 2);
    ASSERT_GT(sharpest(before), 60);
    std::vector<DrawnLine> lines = {before};
    easeLines(lines, reach);
    EXPECT_LT(sharpest(lines[0]), 25);
    for (const DrawnPoint& point : lines[0].points)
        EXPECT_LE(distanceTo(before, point.position), reach + 1e-9);
}

/// Whatever the line's length.
TEST(LineEasing, TakesPointsOfOnePlaceAtTheEnd) {
    for (int i = 0; i < 1000; ++i) {
        DrawnLine line = zigzag(0.1, 5, false, 0.5 + 0.00123 * i);
        line.points.push_back(DrawnPoint(line.points.back()));
        line.points[4].is_exact = false;
        std::vector<DrawnLine> lines = {line};
        easeLines(lines, reach);
        for (const DrawnPoint& point : lines[0].points)
            ASSERT_TRUE(point.position.allFinite());
    }
}

TEST(LineEasing, LeavesNoCornerWhereALoopBegins) {
    DrawnLine loop{LineClass::Outline, true, {}};
    for (int i = 0; i <= 40; ++i) {
        const double angle = 3.141592653589793 * (i % 40) / 20, radius = i % 2 ? 3.1 : 3;
        loop.points.push_back({radius * Vector2d(std::cos(angle), std::sin(angle))});
        loop.points.back().is_exact = false;
    }
    std::vector<DrawnLine> lines = {loop};
    easeLines(lines, reach);
    DrawnLine twice = lines[0];
    twice.points.insert(twice.points.end(), twice.points.begin() + 1, twice.points.end());
    EXPECT_LT(sharpest(twice), 5);
    EXPECT_EQ(lines[0].points.front().position, lines[0].points.back().position);
}

/// An inner line continues as a contour, which stays.
TEST(LineEasing, OfInnerLinesKeepsContoursAndWidths) {
    DrawnLine line{LineClass::Contour, false, {}};
    for (int i = 0; i <= 80; ++i) {
        const bool is_contour = i < 40;
        const double y = is_contour ? 0 : 0.002 * (i - 40) * (i - 40) + (i % 2 ? 0.1 : 0);
        line.points.push_back({{0.25 * i, y}, is_contour ? 1 : 0.5});
        line.points.back().is_exact = is_contour;
    }
    std::vector<DrawnLine> lines = {line};
    easeInnerLines(lines, reach);
    EXPECT_LT(turning(lines[0]), 0.2 * turning(line));
    EXPECT_LT(sharpest(lines[0]), 5);
    for (const DrawnPoint& point : lines[0].points) {
        EXPECT_LE(distanceTo(line, point.position), reach + 1e-9);
        const double step = point.position.x() / 0.25;
        if (step < 39) {
            EXPECT_NEAR(point.position.y(), 0, 1e-9);
        }
        if (step < 38 || step > 42) {
            EXPECT_DOUBLE_EQ(point.weight, step < 38 ? 1 : 0.5);
        }
    }
}

std::size_t kept(const std::vector<DrawnLine>& lines, double kernel = 0) {
    SheetOptions options;
    options.kernel = {kernel, false};
    return withoutSlightLines(lines, options).size();
}

TEST(SlightLines, AreContoursBeforeASmallJumpInDepth) {
    DrawnLine line = zigzag(0.1, 41);
    line.jump = 0.2;
    EXPECT_EQ(kept({line}), 0u);
    line.jump = 0.3;
    EXPECT_EQ(kept({line}), 1u);
    DrawnLine edge = zigzag(0.1, 41, true);
    edge.jump = 0.01;
    EXPECT_EQ(kept({edge}), 1u);
    DrawnLine outline = zigzag(0.1, 41);
    outline.line_class = LineClass::Outline;
    EXPECT_EQ(kept({outline}), 1u);
}

/// Curved surfaces' may be three times as long: scans are rough.
TEST(SlightLines, AreShortContoursThatEndInNothing) {
    DrawnLine contour = zigzag(0, 4);  // 1.5 mm
    contour.jump = 5;
    EXPECT_EQ(kept({contour}), 0u);
    DrawnLine longer = zigzag(0, 6);
    longer.jump = 5;
    EXPECT_EQ(kept({longer}), 1u);
    DrawnLine exact = zigzag(0, 4, true);
    exact.jump = 5;
    EXPECT_EQ(kept({exact}), 1u);
}

TEST(SlightLines, AreContoursShorterThanTheKernelThatMeetNothing) {
    DrawnLine contour = zigzag(0, 6);
    contour.jump = 5;
    const double length = lengthOf(contour.points);
    EXPECT_EQ(kept({contour}, 1.1 * length), 0u);
    EXPECT_EQ(kept({contour}, 0.9 * length), 1u);
    contour.points.front().node = 1;
    const DrawnLine met{LineClass::Edge, false, {{{-5, 0}, 1, 1}, {{-15, 0}, 1, 2}}};
    EXPECT_EQ(kept({contour, met}, 1.1 * length), 2u);
}

TEST(SlightLines, AreLoopsThatTheirStrokeFills) {
    const auto square = [](double side) {
        return DrawnLine{LineClass::Contour,
                         true,
                         {{{0, 0}}, {{side, 0}}, {{side, side}}, {{0, side}}, {{0, 0}}}};
    };
    EXPECT_EQ(kept({square(0.35)}), 0u);
    EXPECT_EQ(kept({square(0.5)}), 1u);
}

TEST(SlightLines, AreShortEndsInNothing) {
    const DrawnLine whole{LineClass::Edge, false, {{{0, 0}, 1, 1}, {{10, 0}, 1, 2}}};
    const auto from_its_end = [](double length) {
        return DrawnLine{LineClass::Edge, false, {{{10, 0}, 1, 2}, {{10, length}, 1, 3}}};
    };
    EXPECT_EQ(kept({whole, from_its_end(0.7)}), 1u);
    EXPECT_EQ(kept({whole, from_its_end(0.9)}), 2u);
    const DrawnLine closing{LineClass::Edge, false, {{{10, 0.7}, 1, 3}, {{0, 0}, 1, 1}}};
    EXPECT_EQ(kept({whole, from_its_end(0.7), closing}), 3u);  // it ends in nothing no more
}

}  // namespace
