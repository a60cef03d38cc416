// SPDX-License-Identifier: GPL-3.0-or-later
// Faces of more than three corners, as files have them.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "sample_files.h"

using Eigen::Vector3d;
using laplacian_lines::Triangle;
using Polygon = std::vector<Vector3d>;

namespace {

mesh_files::MeshInFile file_of(const Polygon& polygon) {
    std::string text = "OFF\n" + std::to_string(polygon.size()) + " 1 0\n", face;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        char line[100];
        std::snprintf(line, sizeof line, "%.17g %.17g %.17g\n", polygon[i].x(), polygon[i].y(),
                      polygon[i].z());
        text += line;
        face += ' ' + std::to_string(i);
    }
    return read_mesh(mesh_files::Format::Off, text + std::to_string(polygon.size()) + face + '\n');
}

/// Of triangles along the normal, less that of flipped ones, and of all.
struct Areas {
    double along = 0, all = 0;
};
Areas areas_of(const Polygon& polygon, const Vector3d& normal) {
    const mesh_files::MeshInFile file = file_of(polygon);
    EXPECT_EQ(file.defect, "");
    EXPECT_EQ(file.mesh.triangles.size(), polygon.size() - 2);
    Areas areas;
    for (const Triangle& t : file.mesh.triangles) {
        const Vector3d area =
            (polygon[t[1]] - polygon[t[0]]).cross(polygon[t[2]] - polygon[t[0]]) / 2;
        areas.along += area.dot(normal);
        areas.all += area.norm();
    }
    return areas;
}

/// A gear in a slanted plane: every second corner is concave.
Polygon gear(int corners, double inner, const Vector3d& normal) {
    const Vector3d right = normal.unitOrthogonal(), up = normal.cross(right);
    Polygon polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::acos(-1.) * i / corners, r = i % 2 ? inner : 1;
        polygon.push_back(Vector3d(5, 6, 7) + r * (std::cos(angle) * right + std::sin(angle) * up));
    }
    return polygon;
}

TEST(Polygons, AreFilledByTheirTrianglesWithoutOverlaps) {
    const Vector3d normal = Vector3d(1, 2, 3).normalized();
    for (const int corners : {4, 6, 12, 100})
        for (const double inner : {0.1, 0.9, 1.0}) {
            const Areas areas = areas_of(gear(corners, inner, normal), normal);
            const double expected = corners * inner * std::sin(2 * std::acos(-1.) / corners) / 2;
            EXPECT_NEAR(areas.along, expected, 1e-9) << corners << ' ' << inner;
            EXPECT_NEAR(areas.all, expected, 1e-9) << corners << ' ' << inner;
        }
}

TEST(Polygons, OfAnyFormHaveTwoTrianglesFewerThanCorners) {
    const Polygon crossed = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
    const Polygon flat = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5, 0, 0}};
    const Polygon point(6, Vector3d(1, 2, 3));
    const Polygon beyond = {
        {0, 0, 0}, {NAN, 0, 0}, {1, INFINITY, 0}, {1e300, 1e300, -1e300}, {0, 1, 0}};
    for (const Polygon& polygon : {crossed, flat, point, beyond})
        areas_of(polygon, Vector3d::UnitZ());
}

/// A roof over a square: its ridge is a diagonal, the ends' middles, or a line between other
/// corners.
TEST(Polygons, ThatAreBentAreCutAlongTheBend) {
    Polygon valley = {{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}};
    Polygon gable = {{0, 0, 0}, {1, 0, .5}, {2, 0, 0}, {2, 3, 0}, {1, 3, .5}, {0, 3, 0}};
    for (int begin = 0; begin < 6; ++begin) {
        EXPECT_NEAR(areas_of(valley, Vector3d::UnitZ()).all, std::sqrt(3), 1e-12) << begin;
        EXPECT_NEAR(areas_of(gable, Vector3d::UnitZ()).all, 6 * std::sqrt(1.25), 1e-12) << begin;
        for (Polygon* polygon : {&valley, &gable})
            std::rotate(polygon->begin(), polygon->begin() + 1, polygon->end());
    }
}

TEST(Polygons, OfManyCornersAreQuickOrRefused) {
    EXPECT_EQ(file_of(gear(100000, 1, Vector3d::UnitZ())).defect, "");
    EXPECT_NE(file_of(gear(100000, 0.99, Vector3d::UnitZ())).defect, "");
}

}  // namespace
