// SPDX-License-Identifier: GPL-3.0-or-later
// Lines are smoothed within a part of their pen; specks, duplicates and hooks at ends are removed;
// curves stay near lines; ends are extended to the lines that they head for.
#include "strokes/strokes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "sheet_helpers.h"

using namespace line_drawing;
using Eigen::Vector2d;
using Points = std::vector<Vector2d>;

namespace {

constexpr double kReach = 0.12;

/// From the x axis up to `height` and back, a point every `spacing` mm.
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

using sheet_helpers::distance_to;
double distance_to(const DrawnLine& line, const Vector2d& p) {
    return distance_to(positions_of(line), p);
}

TEST(StrokeSmoothing, TakesTheTurnsOutAndStaysWithinReach) {
    const DrawnLine before = zigzag(0.1, 41);
    std::vector<DrawnLine> lines = {before};
    smooth_contours(lines, kReach);
    EXPECT_LT(turning(lines[0]), 0.1 * turning(before));
    for (const DrawnPoint& point : lines[0].points)
        EXPECT_LE(distance_to(before, point.position), kReach + 1e-9);
    EXPECT_EQ(lines[0].points.front().position, before.points.front().position);
    EXPECT_EQ(lines[0].points.back().position, before.points.back().position);
}

TEST(StrokeSmoothing, HasEndsFollow) {
    const DrawnLine contour = zigzag(0.1, 41);
    const DrawnLine edge{
        LineClass::Edge, false, {{{10.5, 8}}, {contour.points[21].position, 1, 21, true}}};
    std::vector<DrawnLine> lines = {edge, contour};
    smooth_contours(lines, kReach);
    EXPECT_GT((lines[0].points.back().position - contour.points[21].position).norm(), 0.02);
    EXPECT_LT(distance_to(lines[1], lines[0].points.back().position), 0.01);
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
    return largest * 180 / M_PI;
}

/// Waves too high to smooth away, with a corner each: what bends least touches its tube smoothly,
/// what is shortest would not.
TEST(StrokeSmoothing, LeavesNoCorners) {
    const DrawnLine before = zigzag(1.2, 41, false, 2);
    ASSERT_GT(sharpest(before), 60);
    std::vector<DrawnLine> lines = {before};
    smooth_contours(lines, kReach);
    EXPECT_LT(sharpest(lines[0]), 25);
    for (const DrawnPoint& point : lines[0].points)
        EXPECT_LE(distance_to(before, point.position), kReach + 1e-9);
}

TEST(StrokeSmoothing, LeavesNoCornerWhereALoopBegins) {
    DrawnLine loop{LineClass::Outline, true, {}};
    for (int i = 0; i <= 40; ++i) {
        const double angle = M_PI * (i % 40) / 20, radius = i % 2 ? 3.1 : 3;
        loop.points.push_back({radius * Vector2d(std::cos(angle), std::sin(angle))});
        loop.points.back().is_exact = false;
    }
    std::vector<DrawnLine> lines = {loop};
    smooth_contours(lines, kReach);
    DrawnLine twice = lines[0];
    twice.points.insert(twice.points.end(), twice.points.begin() + 1, twice.points.end());
    EXPECT_LT(sharpest(twice), 5);
    EXPECT_EQ(lines[0].points.front().position, lines[0].points.back().position);
}

std::size_t kept(const std::vector<DrawnLine>& lines, double kernel = 0) {
    SheetOptions options;
    options.kernel.size = kernel;
    return without_specks(lines, options).size();
}

TEST(Specks, AreContoursBeforeASmallJumpInDepth) {
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

TEST(Specks, AreShortLinesThatMeetNothing) {
    for (const bool is_exact : {false, true}) {
        DrawnLine line = zigzag(0, 4, is_exact);  // 1.5 mm
        line.jump = 5;
        EXPECT_EQ(kept({line}), 0u);
        DrawnLine longer = zigzag(0, 6, is_exact);  // 2.5 mm
        longer.jump = 5;
        EXPECT_EQ(kept({longer}), 1u);
        EXPECT_EQ(kept({longer}, 4), 0u);  // √h
    }
}

/// Parts of a ring of this radius, mm, that meet at nodes.
std::vector<DrawnLine> ring(double radius, int parts, int of) {
    std::vector<DrawnLine> lines;
    for (int part = 0; part < parts; ++part) {
        DrawnLine line{LineClass::Edge, false, {}};
        for (int i = 0; i <= 4; ++i) {
            const double angle = 2 * M_PI * (part + i / 4.) / of;
            line.points.push_back({radius * Vector2d(std::cos(angle), std::sin(angle))});
        }
        line.points.front().node = std::uint32_t(part);
        line.points.back().node = std::uint32_t((part + 1) % of);
        lines.push_back(line);
    }
    return lines;
}

TEST(Specks, AreSmallNetsInWhichNoWayLeadsAround) {
    EXPECT_EQ(kept(ring(0.5, 3, 3)), 3u);  // a hole of a screw
    EXPECT_EQ(kept(ring(0.5, 2, 3)), 0u);  // what is left of one
    EXPECT_EQ(kept(ring(2, 2, 3)), 2u);
    EXPECT_EQ(kept(ring(0.1, 3, 3)), 0u);  // a dot
}

/// Of a foot that a wall hides in parts.
TEST(Specks, AreNotEdgesThatLowContoursContinue) {
    DrawnLine line = zigzag(0.1, 41);
    line.jump = 0.2;
    for (std::size_t i = 30; i < line.points.size(); ++i)
        line.points[i].is_exact = true;
    const auto rest = without_specks({line}, SheetOptions());
    ASSERT_EQ(rest.size(), 1u);
    EXPECT_EQ(rest[0].points.front().position, line.points[30].position);
}

constexpr double kTolerance = 0.02;

double largest_distance(const Points& points, const Path& path) {
    const Points line = path.flattened(0.0005).at(0);
    double largest = 0;
    for (const Vector2d& p : points)
        largest = std::max(largest, distance_to(line, p));
    return largest;
}

/// There and back: something seen edge-on.
TEST(CurveFitting, ReachesTheEndsOfFlatLoops) {
    for (const double height : {0.0, 0.001, 0.05}) {
        const Points points = {{0, 0}, {70, 0}, {70, height}, {0, height}, {0, 0}};
        Path path;
        fit_curve(points, true, kTolerance, path);
        EXPECT_LT(largest_distance(points, path), 1.1 * kTolerance) << height;
    }
}

TEST(CurveFitting, OfARingDoesNotDependOnWhereItBegins) {
    Points square;  // in steps of a tolerance and a half
    for (const Vector2d& way : {Vector2d(1, 0), Vector2d(0, 1), Vector2d(-1, 0), Vector2d(0, -1)})
        for (int i = 0; i < 40; ++i)
            square.push_back((square.empty() ? Vector2d(0, 0) : square.back()) +
                             1.5 * kTolerance * way);
    for (std::size_t begin = 0; begin < square.size(); ++begin) {
        Points points(square.begin() + std::ptrdiff_t(begin), square.end());
        points.insert(points.end(), square.begin(), square.begin() + std::ptrdiff_t(begin) + 1);
        Path path;
        fit_curve(points, true, kTolerance, path);
        EXPECT_EQ(path.pieces.size(), 5u) << begin;  // the corners, and the first again
    }
}

/// Between points, too: long handles could leap there.
TEST(CurveFitting, StaysNearLinesOfAnyShape) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0, 1);
    for (int line = 0; line < 2000; ++line) {
        Points points = {{0, 0}};
        double angle = 0;
        const double turn = 3 * share(random), step = 0.01 + 0.5 * share(random);
        for (int i = 0; i < 40; ++i) {
            angle += turn * (share(random) - 0.5);
            points.push_back(points.back() +
                             step * share(random) * Vector2d(std::cos(angle), std::sin(angle)));
        }
        Path path;
        fit_curve(points, false, kTolerance, path);
        const Points curve = path.flattened(0.0005).at(0);
        double largest = 0;
        for (const Vector2d& p : curve)
            largest = std::max(largest, distance_to(points, p));
        ASSERT_LT(largest, 3 * kTolerance) << line;
    }
}

constexpr double kDoubleReach = 0.2;

DrawnLine line(LineClass line_class, std::initializer_list<Eigen::Vector2d> positions) {
    DrawnLine result{line_class, false, {}};
    for (const Eigen::Vector2d& p : positions)
        result.points.push_back({p, 1});
    return result;
}

TEST(Overlaps, ALineAlongAnOutlineIsLeftOutThereOnly) {
    const auto rest = without_doubles({line(LineClass::Inner, {{0, 5}, {0, 0.1}, {20, 0.1}}),
                                       line(LineClass::Outline, {{-10, 0}, {30, 0}})},
                                      kDoubleReach);
    ASSERT_EQ(rest.size(), 2u);
    EXPECT_EQ(rest[0].line_class, LineClass::Outline);
    EXPECT_EQ(rest[0].points.size(), 2u);
    EXPECT_EQ(rest[1].points.front().position, Eigen::Vector2d(0, 5));
    EXPECT_LT(rest[1].points.back().position.y(), 0.4);
    EXPECT_LE(rest[1].points.back().position.x(), 2 * kDoubleReach);
}

TEST(Overlaps, ALineStaysBetweenThoseThatItDoubles) {
    const double end = 5, begin = end + 1.9 * kDoubleReach, middle = (end + begin) / 2;
    const auto rest = without_doubles(
        {line(LineClass::Contour, {{0, 0}, {end, 0}}),
         line(LineClass::Contour, {{begin, 0}, {12, 0}}), line(LineClass::Edge, {{0, 0}, {12, 0}})},
        kDoubleReach);
    ASSERT_EQ(rest.size(), 3u);
    EXPECT_LT(rest[2].points.front().position.x(), middle);
    EXPECT_GT(rest[2].points.back().position.x(), middle);
    EXPECT_LT(length_of(rest[2].points), 8 * kDoubleReach);
}

/// One that has passed the line it met is cut back to it, and two that have passed each other end
/// in one place, as where a hub's rims are cut into triangles at different places.
TEST(Overlaps, EdgesDoNotGoPastTheirCorners) {
    std::vector<DrawnLine> lines = {line(LineClass::Contour, {{0, 0}, {0, 10.05}}),
                                    line(LineClass::Contour, {{-9, 10}, {0, 10}})};
    join_edges(lines, {}, kDoubleReach);
    EXPECT_EQ(lines[0].points.back().position, Eigen::Vector2d(0, 10));
    EXPECT_EQ(lines[0].points.size(), 2u) << "without a way back";
    lines = {line(LineClass::Edge, {{-9, 0}, {0.04, 0.1}}),
             line(LineClass::Edge, {{0, 0}, {9, -0.1}})};
    join_edges(lines, {}, kDoubleReach);
    EXPECT_EQ(lines[0].points.back().position, lines[1].points.front().position);
}

/// Short bumps leave no white beside a line; real lines do.
TEST(Overlaps, ShortLinesBesideAnotherAreLeftOut) {
    const DrawnLine outline = line(LineClass::Contour, {{0, 0}, {20, 0}});
    const auto rest_of = [&](const DrawnLine& bump) {
        return without_doubles({outline, bump}, kDoubleReach).size() - 1;
    };
    const double near = 1.3 * kDoubleReach, far = 2 * kDoubleReach;
    const auto bump = [](double x, double height) {
        return line(LineClass::Contour, {{5, 0.1}, {5.1, height}, {x, height}, {x + 0.1, 0.1}});
    };
    EXPECT_EQ(rest_of(bump(5.6, near)), 0u);
    EXPECT_EQ(rest_of(bump(5.6, far)), 1u);
    EXPECT_EQ(rest_of(bump(8, near)), 1u);  // long
    // Goes on from where the outline ends.
    EXPECT_EQ(rest_of(line(LineClass::Contour, {{20.12, 0.05}, {20.25, 0.05}})), 1u);
    EXPECT_EQ(rest_of(line(LineClass::Contour, {{5, near}, {5.5, 0.1}})), 1u);
}

constexpr double kPen = 0.25;

/// 10 mm along x, then `length` at `degrees`, in steps of .1 mm.
DrawnLine hooked(double length, double degrees) {
    DrawnLine line{LineClass::Inner, false, {}};
    const double angle = degrees * M_PI / 180;
    for (int i = 0; i <= 100; ++i)
        line.points.push_back({{0.1 * i, 0}});
    for (double at = 0.1; at < length + 0.05; at += 0.1)
        line.points.push_back({{10 + at * std::cos(angle), at * std::sin(angle)}});
    for (DrawnPoint& point : line.points)
        point.is_exact = false;
    return line;
}

double length_without_hooks(std::vector<DrawnLine> lines) {
    cut_hooks(lines, kPen);
    return length_of(lines[0].points);
}

TEST(EndHooks, AreCutAtBothEnds) {
    DrawnLine line = hooked(1, 100);
    EXPECT_NEAR(length_without_hooks({line}), 10, kPen);
    std::reverse(line.points.begin(), line.points.end());
    EXPECT_NEAR(length_without_hooks({line}), 10, kPen);
}

TEST(EndHooks, AreNoBendsOfTheFeature) {
    EXPECT_NEAR(length_without_hooks({hooked(1, 40)}), 11, 1e-6);   // a gentle bend
    EXPECT_NEAR(length_without_hooks({hooked(5, 100)}), 15, 1e-6);  // long
}

TEST(EndHooks, AreLongWhereTheyAreFaint) {
    DrawnLine line = hooked(4, 100);
    for (DrawnPoint& point : line.points)
        if (point.position.y() > 0) point.weight = 0.5;
    EXPECT_NEAR(length_without_hooks({line}), 10, kPen);
    line = hooked(6, 100);
    for (DrawnPoint& point : line.points)
        if (point.position.y() > 0) point.weight = 0.5;
    EXPECT_NEAR(length_without_hooks({line}), 16, 1e-6);  // more than a third
}

/// Least and greatest width, mm, of a line of 10 mm along x without `end` mm at each end.
std::pair<double, double> widths(const DrawnLine& line, double end) {
    double least = INFINITY, most = 0;
    for (const DrawnPoint& point : line.points) {
        const double x = point.position.x(), width = kPen * point.weight;
        if (x < end || x > 10 - end) continue;
        least = std::min(least, width);
        most = std::max(most, width);
    }
    return {least, most};
}

TEST(PointedEnds, AreWhereNothingIsMet) {
    DrawnLine strong = hooked(0, 0), faint = strong;
    for (DrawnPoint& point : faint.points)
        point.weight = 0.1;
    for (const DrawnLine& line : {strong, faint}) {
        std::vector<DrawnLine> lines = {line};
        point_ends(lines, pens_of(Weights::Illustrator));
        EXPECT_EQ(lines[0].points.front().weight, 0);
        EXPECT_NEAR(lines[0].points.back().weight, 0, 1e-9);
        EXPECT_GE(widths(lines[0], 6 * kPen).first, 0.13 - 1e-9) << "black";
        EXPECT_NEAR(widths(lines[0], 3.5).second, line.points[0].weight < 1 ? 0.13 : kPen, 1e-9);
    }
    std::vector<DrawnLine> lines = {strong, line(LineClass::Outline, {{0, -5}, {0, 5}}),
                                    line(LineClass::Outline, {{10, -5}, {10, 5}})};
    point_ends(lines, pens_of(Weights::Illustrator));
    EXPECT_EQ(widths(lines[0], 0), std::pair(kPen, kPen));
}

/// Along x to 10 mm, in steps of .1, towards an outline across the axis at `x`.
std::vector<DrawnLine> heading_for(double x, double weight = 1) {
    DrawnLine line = hooked(0, 0);
    for (DrawnPoint& point : line.points)
        point.weight = weight;
    return {line, {LineClass::Outline, false, {{{x, -5}}, {{x, 5}}}}};
}

TEST(InnerEnds, AreLedToTheLineThatTheyHeadFor) {
    std::vector<DrawnLine> lines = heading_for(10.7);
    const std::vector<MetEnd> met = join_ends(lines, kPen);
    ASSERT_EQ(met.size(), 1u);
    EXPECT_TRUE(met[0].is_last);
    EXPECT_EQ(met[0].met, 1u);
    EXPECT_NEAR(lines[0].points.back().position.x(), 10.7, 1e-9);
    EXPECT_EQ(lines[0].points.front().position.x(), 0);
}

TEST(InnerEnds, StayWhereNothingIsMet) {
    std::vector<DrawnLine> far = heading_for(10.8), faint = heading_for(10.7, 0.4),
                           aside = heading_for(10.7);
    aside[1].points = {{{0, 0.6}}, {{20, 0.6}}};
    for (auto* lines : {&far, &faint, &aside}) {
        EXPECT_TRUE(join_ends(*lines, kPen).empty());
        EXPECT_EQ((*lines)[0].points.back().position.x(), 10);
    }
}

}  // namespace
