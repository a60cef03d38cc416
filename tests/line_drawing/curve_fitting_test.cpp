// SPDX-License-Identifier: GPL-3.0-or-later
#include "strokes/curve_fitting.h"

#include <gtest/gtest.h>

#include <QPolygonF>
#include <QTransform>
#include <cmath>
#include <limits>
#include <random>

using Eigen::Vector2d;
using line_drawing::findCorners;
using line_drawing::fitCurve;
using Points = std::vector<Vector2d>;

namespace {

constexpr double tolerance = 0.02;

int curvesOf(const QPainterPath& path) {
    int count = 0;
    for (int i = 0; i < path.elementCount(); ++i)
        count += path.elementAt(i).isCurveTo();
    return count;
}

double distanceTo(const QPolygonF& polygon, const Vector2d& p) {
    double least = std::numeric_limits<double>::max();
    for (int i = 1; i < polygon.size(); ++i) {
        const Vector2d a(polygon[i - 1].x(), polygon[i - 1].y());
        const Vector2d way = Vector2d(polygon[i].x(), polygon[i].y()) - a;
        const double length = way.squaredNorm();
        const double t = length > 0 ? std::clamp(way.dot(p - a) / length, 0., 1.) : 0;
        least = std::min(least, (a + t * way - p).norm());
    }
    return least;
}

/// Of the points from the curve.
double largestDistance(const Points& points, const QPainterPath& path) {
    const QTransform larger = QTransform::fromScale(1000, 1000);
    const QPolygonF polygon = larger.inverted().map(path.toSubpathPolygons(larger).value(0));
    double largest = 0;
    for (const Vector2d& p : points)
        largest = std::max(largest, distanceTo(polygon, p));
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

/// There and back: what is seen from its edge.
TEST(CurveFitting, ReachesTheEndsOfFlatLoops) {
    for (const double height : {0.0, 0.001, 0.05}) {
        const Points points = {{0, 0}, {70, 0}, {70, height}, {0, height}, {0, 0}};
        QPainterPath path;
        fitCurve(points, true, tolerance, path);
        EXPECT_LT(largestDistance(points, path), 1.1 * tolerance) << height;
    }
}

TEST(CurveFitting, OfACircleTakesFewCurvesAndStaysWithinTheTolerance) {
    const Points points = circle(500, 20);
    QPainterPath path;
    fitCurve(points, true, tolerance, path);
    EXPECT_LE(largestDistance(points, path), 1.01 * tolerance);
    EXPECT_LE(curvesOf(path), 12);
    EXPECT_EQ(QPointF(path.elementAt(0)), path.currentPosition());
}

/// Between the points, too: a curve with long handles could pass all of them and leap in between.
TEST(CurveFitting, StaysNearLinesOfAnyShape) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0, 1);
    for (int line = 0; line < 2000; ++line) {
        Points points = {{0, 0}};
        QPolygonF polygon(QVector<QPointF>{QPointF(0, 0)});
        double angle = 0;
        const double turn = 3 * share(random), step = 0.01 + 0.5 * share(random);
        for (int i = 0; i < 40; ++i) {
            angle += turn * (share(random) - 0.5);
            points.push_back(points.back() +
                             step * share(random) * Vector2d(std::cos(angle), std::sin(angle)));
            polygon << QPointF(points.back().x(), points.back().y());
        }
        QPainterPath path;
        fitCurve(points, false, tolerance, path);
        const QTransform larger = QTransform::fromScale(1000, 1000);
        double largest = 0;
        for (const QPointF& p : larger.inverted().map(path.toSubpathPolygons(larger).value(0)))
            largest = std::max(largest, distanceTo(polygon, {p.x(), p.y()}));
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
    QPainterPath path;
    fitCurve(points, false, tolerance, path);
    EXPECT_EQ(path.elementCount(), 3);
    bool has_corner = false;
    for (int i = 0; i < path.elementCount(); ++i)
        has_corner |= QPointF(path.elementAt(i)) == QPointF(10, 0);
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
    QPainterPath path;
    fitCurve(points, true, tolerance, path);
    EXPECT_EQ(path.elementCount(), 5);
    EXPECT_LE(largestDistance(points, path), 1.01 * tolerance);
    EXPECT_EQ(path.boundingRect(), QRectF(0, 0, 5, 5));
}

TEST(CurveFitting, FollowsAWildLine) {
    Points points;
    unsigned seed = 1;
    for (int i = 0; i < 3000; ++i) {
        seed = seed * 1664525u + 1013904223u;
        points.emplace_back(i * 0.05 + (seed >> 16) * 1e-5,
                            5 * std::sin(i * 0.03) + (seed >> 20) * 1e-3);
    }
    QPainterPath path;
    fitCurve(points, false, tolerance, path);
    EXPECT_LE(largestDistance(points, path), 1.01 * tolerance);
}

TEST(CurveFitting, KeepsAngularLinesOfFewPoints) {
    const Points points = {{0, 0}, {20, 0}, {40, 12}, {45, 50}};
    QPainterPath path;
    fitCurve(points, false, tolerance, path);
    EXPECT_EQ(path.elementCount(), 4);
    EXPECT_LE(largestDistance(points, path), 1e-9);
}

TEST(CurveFitting, OfOnePlaceIsEmpty) {
    QPainterPath path;
    fitCurve(Points(10, Vector2d(1, 2)), false, tolerance, path);
    fitCurve({}, true, tolerance, path);
    EXPECT_TRUE(path.isEmpty());
}

TEST(CurveFitting, OfTwoPointsIsStraight) {
    QPainterPath path;
    fitCurve({{0, 0}, {3, 4}}, false, tolerance, path);
    EXPECT_EQ(path.elementCount(), 2);
    EXPECT_EQ(path.currentPosition(), QPointF(3, 4));
}

}  // namespace
