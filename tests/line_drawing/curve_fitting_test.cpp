// SPDX-License-Identifier: GPL-3.0-or-later
#include "strokes/curve_fitting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using Eigen::Vector2d;
using line_drawing::findCorners;
using line_drawing::fitCurve;
using line_drawing::Path;
using Points = std::vector<Vector2d>;

namespace {

constexpr double tolerance = 0.02;

int curvesOf(const Path& path) {
    return int(std::count_if(path.pieces.begin(), path.pieces.end(), [](const Path::Piece& piece) {
        return piece.step == Path::Step::Curve;
    }));
}

double distanceTo(const Points& line, const Vector2d& p) {
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Vector2d &a = line[i - 1], way = line[i] - a;
        const double length = way.squaredNorm();
        const double t = length > 0 ? std::clamp(way.dot(p - a) / length, 0., 1.) : 0;
        least = std::min(least, (a + t * way - p).norm());
    }
    return least;
}

double largestDistance(const Points& points, const Path& path) {
    const Points line = path.flattened(0.0005).at(0);
    double largest = 0;
    for (const Vector2d& p : points)
        largest = std::max(largest, distanceTo(line, p));
    return largest;
}

Points circle(int n, double radius) {
    Points points;
    for (int i = 0; i <= n; ++i) {
        const double a = i % n * 2 * M_PI / n;
        points.emplace_back(radius * std::cos(a), radius * std::sin(a));
    }
    return points;
}

/// There and back: something seen edge-on.
TEST(CurveFitting, ReachesTheEndsOfFlatLoops) {
    for (const double height : {0.0, 0.001, 0.05}) {
        const Points points = {{0, 0}, {70, 0}, {70, height}, {0, height}, {0, 0}};
        Path path;
        fitCurve(points, true, tolerance, path);
        EXPECT_LT(largestDistance(points, path), 1.1 * tolerance) << height;
    }
}

TEST(CurveFitting, OfACircleTakesFewCurvesAndStaysWithinTheTolerance) {
    const Points points = circle(500, 20);
    Path path;
    fitCurve(points, true, tolerance, path);
    EXPECT_LE(largestDistance(points, path), 1.01 * tolerance);
    EXPECT_LE(curvesOf(path), 12);
    EXPECT_EQ(path.pieces.front().end, path.pieces.back().end);
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
        fitCurve(points, false, tolerance, path);
        const Points curve = path.flattened(0.0005).at(0);
        double largest = 0;
        for (const Vector2d& p : curve)
            largest = std::max(largest, distanceTo(points, p));
        ASSERT_LT(largest, 3 * tolerance) << line;
    }
}

TEST(CurveFitting, KeepsCorners) {
    Points points;
    for (int i = 0; i <= 100; ++i)
        points.emplace_back(i * 0.1, 0);
    for (int i = 1; i <= 100; ++i)
        points.emplace_back(10, i * 0.1);
    EXPECT_EQ(findCorners(points, false, 0.2), std::vector<std::size_t>{100});
    Path path;
    fitCurve(points, false, tolerance, path);
    EXPECT_EQ(path.pieces.size(), 3u);
    bool has_corner = false;
    for (const Path::Piece& piece : path.pieces)
        has_corner |= piece.end == Vector2d(10, 0);
    EXPECT_TRUE(has_corner);
}

TEST(CurveFitting, OfASquareBeginsAtACornerAndHasFour) {
    Points points;
    const Vector2d corners[] = {{0, 0}, {5, 0}, {5, 5}, {0, 5}, {0, 0}};
    for (int side = 0; side < 4; ++side)
        for (int i = 0; i < 50; ++i)
            points.push_back(corners[side] + (corners[side + 1] - corners[side]) * i / 50.);
    std::rotate(points.begin(), points.begin() + 20, points.end());
    points.push_back(points.front());
    EXPECT_EQ(findCorners(points, true, 0.2).size(), 4u);
    Path path;
    fitCurve(points, true, tolerance, path);
    EXPECT_EQ(path.pieces.size(), 5u);
    EXPECT_LE(largestDistance(points, path), 1.01 * tolerance);
    EXPECT_EQ(path.bounds().min(), Vector2d(0, 0));
    EXPECT_EQ(path.bounds().max(), Vector2d(5, 5));
}

TEST(CurveFitting, FollowsAWildLine) {
    Points points;
    unsigned seed = 1;
    for (int i = 0; i < 3000; ++i) {
        seed = seed * 1664525u + 1013904223u;
        points.emplace_back(i * 0.05 + (seed >> 16) * 1e-5,
                            5 * std::sin(i * 0.03) + (seed >> 20) * 1e-3);
    }
    Path path;
    fitCurve(points, false, tolerance, path);
    EXPECT_LE(largestDistance(points, path), 1.01 * tolerance);
}

TEST(CurveFitting, KeepsAngularLinesOfFewPoints) {
    const Points points = {{0, 0}, {20, 0}, {40, 12}, {45, 50}};
    Path path;
    fitCurve(points, false, tolerance, path);
    EXPECT_EQ(path.pieces.size(), 4u);
    EXPECT_LE(largestDistance(points, path), 1e-9);
}

TEST(CurveFitting, OfOnePlaceIsEmpty) {
    Path path;
    fitCurve(Points(10, Vector2d(1, 2)), false, tolerance, path);
    fitCurve({}, true, tolerance, path);
    EXPECT_TRUE(path.isEmpty());
}

TEST(CurveFitting, OfTwoPointsIsStraight) {
    Path path;
    fitCurve({{0, 0}, {3, 4}}, false, tolerance, path);
    EXPECT_EQ(path.pieces.size(), 2u);
    EXPECT_EQ(path.pieces.back().end, Vector2d(3, 4));
}

}  // namespace
