// SPDX-License-Identifier: GPL-3.0-or-later
#include "polygons.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>

using Eigen::Vector3d;
using laplacian_lines::Triangle;
using Polygon = std::vector<Vector3d>;

namespace {

const double kTurn = 2 * std::acos(-1.0);

std::vector<Triangle> triangles_of(const Polygon& polygon, std::size_t work = 1000000) {
    std::vector<std::uint32_t> corners(polygon.size());
    std::iota(corners.begin(), corners.end(), 0);
    std::vector<Triangle> triangles;
    EXPECT_TRUE(mesh_files::triangulate(polygon, corners.data(), corners.size(), work, triangles));
    return triangles;
}

/// Of triangles along the normal, and of flipped ones.
struct Areas {
    double sum = 0, against = 0;
};
Areas areas_of(const Polygon& polygon, const Vector3d& normal) {
    Areas areas;
    for (const Triangle& t : triangles_of(polygon)) {
        const double area =
            (polygon[t[1]] - polygon[t[0]]).cross(polygon[t[2]] - polygon[t[0]]).dot(normal) / 2;
        areas.sum += area;
        areas.against += std::max(0., -area);
    }
    return areas;
}

/// A gear in a slanted plane: every second corner is concave.
Polygon star(int corners, double inner, const Vector3d& normal) {
    const Vector3d right = normal.unitOrthogonal(), up = normal.cross(right);
    Polygon polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = kTurn * i / corners, r = i % 2 ? inner : 1;
        polygon.push_back(Vector3d(5, 6, 7) + r * (std::cos(angle) * right + std::sin(angle) * up));
    }
    return polygon;
}

TEST(Polygons, AreFilledByTheirTrianglesWithoutOverlaps) {
    const Vector3d normal = Vector3d(1, 2, 3).normalized();
    for (const int corners : {4, 6, 8, 12, 100})
        for (const double inner : {0.1, 0.5, 0.9, 1.0}) {
            const Polygon polygon = star(corners, inner, normal);
            const double sine = std::sin(kTurn / corners) / 2;
            const Areas areas = areas_of(polygon, normal);
            EXPECT_NEAR(areas.sum, corners * inner * sine, 1e-9) << corners << ' ' << inner;
            EXPECT_LT(areas.against, 1e-9) << corners << ' ' << inner;
            EXPECT_EQ(triangles_of(polygon).size(), polygon.size() - 2);
        }
}

TEST(Polygons, OfAnyFormHaveTwoTrianglesFewerThanCorners) {
    const Polygon crossed = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
    const Polygon flat = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5, 0, 0}};
    const Polygon point(6, Vector3d(1, 2, 3));
    const Polygon beyond = {
        {0, 0, 0}, {NAN, 0, 0}, {1, INFINITY, 0}, {1e300, 1e300, -1e300}, {0, 1, 0}};
    for (const Polygon& polygon : {crossed, flat, point, beyond})
        EXPECT_EQ(triangles_of(polygon).size(), polygon.size() - 2);
}

double area_of(const Polygon& polygon) {
    double sum = 0;
    for (const Triangle& t : triangles_of(polygon))
        sum += (polygon[t[1]] - polygon[t[0]]).cross(polygon[t[2]] - polygon[t[0]]).norm() / 2;
    return sum;
}

/// A roof over a square: its ridge is a diagonal, the ends' middles, or a line between other
/// corners.
TEST(Polygons, ThatAreBentAreCutAlongTheBend) {
    const double bent = std::sqrt(1.25);
    Polygon valley = {{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}};
    Polygon gable = {{0, 0, 0}, {1, 0, .5}, {2, 0, 0}, {2, 3, 0}, {1, 3, .5}, {0, 3, 0}};
    Polygon dart = {{0, 0, 0}, {3, 0, 0}, {1, 1, .1}, {0, 3, 0}};  // beyond a diagonal
    for (int begin = 0; begin < 12; ++begin) {
        EXPECT_NEAR(area_of(valley), std::sqrt(3), 1e-12) << begin;
        EXPECT_NEAR(area_of(gable), 6 * bent, 1e-12) << begin;
        EXPECT_LT(areas_of(dart, Vector3d::UnitZ()).against, 1e-12) << begin;
        for (Polygon* polygon : {&valley, &gable, &dart})
            std::rotate(polygon->begin(), polygon->begin() + 1, polygon->end());
    }
    const Polygon sheared = {{0, 0, 0}, {4, 0, 0}, {5, 1, 1}, {1, 1, 0}};
    EXPECT_NEAR(area_of(sheared), area_of({sheared[1], sheared[2], sheared[3], sheared[0]}), 1e-12);
}

TEST(Polygons, OfManyCornersAreQuickOrRefused) {
    EXPECT_EQ(triangles_of(star(100000, 1, Vector3d::UnitZ()), 200000).size(), 99998u);
    const Polygon gear = star(100000, 0.99, Vector3d::UnitZ());
    std::vector<std::uint32_t> corners(gear.size());
    std::iota(corners.begin(), corners.end(), 0);
    std::vector<Triangle> triangles;
    std::size_t work = 1000000;
    EXPECT_FALSE(mesh_files::triangulate(gear, corners.data(), corners.size(), work, triangles));
}

}  // namespace
