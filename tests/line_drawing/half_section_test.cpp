// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "laplacian_lines/error.h"
#include "sections/half_section.h"
#include "sheet_helpers.h"

using namespace line_drawing;
using Eigen::Vector3d;
using laplacian_lines::TriangleMesh;
using sheet_helpers::layer_of;
using sheet_helpers::painter_path;
using test_meshes::moved;

namespace {

TriangleMesh small_vessel(double relief = 1) {
    return test_meshes::thrown_vessel({200, 120, relief});
}

SheetOptions vessel_options() {
    SheetOptions options;
    options.views = parse_views("vessel", UpAxis::Y);
    options.paper = "fit";
    options.scale = 1;
    options.strokes = StrokeStyle::Plain;
    options.wall = WallStyle::Filled;
    return options;
}

TriangleMesh turned_aside(const TriangleMesh& mesh, double degrees) {
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(degrees * M_PI / 180, Vector3d::UnitX()).toRotationMatrix();
    return test_meshes::mapped(mesh, [&](Vector3d& p) { p = rotation * p; });
}

TriangleMesh sherd_of(const TriangleMesh& mesh, double degrees) {
    TriangleMesh part = mesh;
    part.triangles.clear();
    for (const auto& t : mesh.triangles) {
        const Vector3d& p = mesh.positions[t[0]];
        if (std::abs(std::atan2(p.z(), p.x())) < degrees / 2 * M_PI / 180)
            part.triangles.push_back(t);
    }
    return part;
}

/// With shoulders; each of few sides is two triangles, which lie to either side of its middle.
TriangleMesh can(std::uint32_t sides) {
    TriangleMesh mesh;
    const std::vector<Eigen::Vector2d> profile = {{50, 0}, {66, 9}, {66, 114}, {54, 128}};
    for (const Eigen::Vector2d& p : profile)
        for (std::uint32_t i = 0; i < sides; ++i) {
            const double angle = 2 * M_PI * i / sides;
            mesh.positions.emplace_back(p.x() * std::cos(angle), p.y(), -p.x() * std::sin(angle));
        }
    const std::uint32_t last = 3 * sides;
    for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t next = (i + 1) % sides;
        for (std::uint32_t ring = 0; ring < last; ring += sides) {
            const std::uint32_t a = ring + i, b = ring + next, c = b + sides, d = a + sides;
            if (2 * i < sides) {
                mesh.triangles.push_back({a, b, c});
                mesh.triangles.push_back({a, c, d});
            } else {
                mesh.triangles.push_back({a, b, d});
                mesh.triangles.push_back({b, c, d});
            }
        }
        if (i == 0 || next == 0) continue;
        mesh.triangles.push_back({0, next, i});
        mesh.triangles.push_back({last, last + i, last + next});
    }
    return mesh;
}

TEST(HalfSection, IsUprightWhateverItsTriangles) {
    for (const std::uint32_t sides : {8u, 13u, 24u, 30u}) {
        const Sheet sheet = sheet_helpers::sheet_of(can(sides), vessel_options());
        EXPECT_EQ(sheet.remarks.at(0).find("Vessel: rim 100 %, axis off by 0.0"), 0u)
            << sides << ' ' << sheet.remarks[0];
        const TriangleMesh tiny = moved(can(sides), {0, 0, 0}, 1e-9);
        EXPECT_NO_THROW(HalfSection(tiny, vessel_options().views[0]).expect_vessel());
    }
}

TEST(HalfSection, IsRefusedOfWhatIsNoVessel) {
    const auto draw = [](const TriangleMesh& mesh) {
        return sheet_helpers::sheet_of(mesh, vessel_options());
    };
    EXPECT_THROW(draw(sheet_helpers::cube_of100()), laplacian_lines::Error);
    EXPECT_THROW(draw(turned_aside(small_vessel(), 20)), laplacian_lines::Error);
    EXPECT_THROW(draw(sherd_of(small_vessel(), 60)), laplacian_lines::Error);
    try {
        draw(turned_aside(small_vessel(), 90));
        ADD_FAILURE();
    } catch (const laplacian_lines::Error& error) {
        EXPECT_EQ(std::string(error.what()),
                  "The vessel stands along z: choose this axis to point up.");
    }
    const Sheet sheet = sheet_helpers::sheet_of(sherd_of(small_vessel(), 270), vessel_options());
    ASSERT_EQ(sheet.remarks.size(), 1);
    EXPECT_EQ(sheet.remarks[0].find("Vessel: rim 7"), 0u) << sheet.remarks[0];
    EXPECT_TRUE(sheet_helpers::has(joined(sheet_helpers::texts_of(sheet), "|"), "rim 7"));
}

TEST(HalfSection, DrawsTheWallOnTheLeftAndTheOutsideOnTheRight) {
    const Sheet sheet = sheet_helpers::sheet_of(small_vessel(0), vessel_options());
    const SheetGroup& vessel = sheet.groups.at(0);
    EXPECT_EQ(vessel.key, "vessel");
    const SheetLayer& wall = layer_of(vessel, "section");
    QRectF all = sheet_helpers::extent_of(vessel);
    double area = 0;
    for (const SheetPath& path : wall.paths) {
        EXPECT_LE(painter_path(path.path).boundingRect().right(), all.center().x() + 0.05);
        if (path.pen_width == 0) area += sheet_helpers::area_of(path);
    }
    double expected = 0;  // of the profile, which ends on the axis
    const auto profile = test_meshes::vessel_profile(2000);
    for (std::size_t i = 1; i < profile.size(); ++i)
        expected += (profile[i - 1].x() * profile[i].y() - profile[i - 1].y() * profile[i].x()) / 2;
    EXPECT_NEAR(area, std::abs(expected), 0.02 * std::abs(expected));
    ASSERT_FALSE(layer_of(vessel, "outline").paths.empty());
    for (const SheetPath& path : layer_of(vessel, "outline").paths)
        EXPECT_GE(painter_path(path.path).boundingRect().left(), all.center().x() - 0.05);
}

/// Along the way from `left` to `right` at this height.
double share_drawn(const SheetGroup& view, double height, double left, double right) {
    std::vector<bool> is_drawn(100);
    for (const SheetLayer& layer : view.layers)
        for (const SheetPath& path : layer.paths)
            for (double t = 0; t <= 1; t += 1e-3) {
                const QPointF p = painter_path(path.path).pointAtPercent(t);
                const double place = (p.x() - left) / (right - left) * double(is_drawn.size());
                if (std::abs(p.y() - height) < 0.5 && place >= 0 && place < double(is_drawn.size()))
                    is_drawn[std::size_t(place)] = true;
            }
    return double(std::count(is_drawn.begin(), is_drawn.end(), true)) / double(is_drawn.size());
}

/// From the left edge to the upright line from end to end, mm.
double axis_of(const SheetGroup& view) {
    const QRectF all = sheet_helpers::extent_of(view);
    for (const SheetPath& path : layer_of(view, "inner").paths) {
        const QRectF box = painter_path(path.path).boundingRect();
        if (box.width() < 0.01 && box.height() > all.height() - 0.1)
            return box.center().x() - all.left();
    }
    throw std::logic_error("there is no axis");
}

TEST(HalfSection, HasAnAxisAndLinesThroughRimAndBase) {
    const Sheet sheet = sheet_helpers::sheet_of(small_vessel(0), vessel_options());
    const QRectF all = sheet_helpers::extent_of(sheet.groups.at(0));
    const double middle = all.center().x();
    EXPECT_NEAR(all.left() + axis_of(sheet.groups[0]), middle, 0.2);
    EXPECT_GT(share_drawn(sheet.groups[0], all.top(), middle - 15, middle + 15), 0.95);
    EXPECT_GT(share_drawn(sheet.groups[0], all.bottom(), middle - 15, middle + 15), 0.95);
}

TEST(HalfSection, KeepsItsLinesFarFromZero) {
    const TriangleMesh vessel = small_vessel();
    const auto length_at = [&](const Vector3d& place) {
        double length = 0;
        const Sheet sheet = sheet_helpers::sheet_of(moved(vessel, place), vessel_options());
        for (const SheetLayer& layer : sheet.groups.at(0).layers)
            length += sheet_helpers::length_of(layer);
        return length;
    };
    const double length = length_at({0, 0, 0});
    ASSERT_GT(length, 400) << "the wall and the outside, 200 mm high";
    EXPECT_NEAR(length_at({5e5, 0, 5e6}), length, 0.01 * length);
}

TEST(HalfSection, HasNoLineFromTheInsideToTheOutside) {
    // Numbers of ends inside are also those of some outside.
    const TriangleMesh jar = test_meshes::thrown_vessel({100, 260});
    const Sheet sheet = sheet_helpers::sheet_of(jar, vessel_options());
    const SheetGroup& vessel = sheet.groups.at(0);
    const QRectF all = sheet_helpers::extent_of(vessel);
    ASSERT_GT(all.height(), 190);
    const double middle = all.center().x();
    for (const SheetLayer& layer : vessel.layers)
        for (const SheetPath& path : layer.paths) {
            const QRectF box = painter_path(path.path).boundingRect();
            const bool is_across = box.left() < middle - 1 && box.right() > middle + 1;
            EXPECT_FALSE(is_across && box.height() > 1) << layer.key;  // rim and base are level
        }
}

TEST(HalfSection, HasTheAxisOfRevolutionAlsoBesideAHandle) {
    const TriangleMesh jar = small_vessel();
    const TriangleMesh handle = moved(test_meshes::torus(60, 30).mesh, {1100, 107, -300}, 25),
                       mesh = test_meshes::together(moved(jar, {1000, 7, -300}), handle);
    const auto axis = [](const TriangleMesh& drawn) {
        return axis_of(sheet_helpers::sheet_of(drawn, vessel_options()).groups.at(0));
    };
    EXPECT_NEAR(axis(mesh), axis(jar), 0.3);
}

TEST(HalfSection, StandsBesideAFrontView) {
    SheetOptions options = vessel_options();
    options.views = parse_views("front,vessel", UpAxis::Y);
    const Sheet sheet = sheet_helpers::sheet_of(small_vessel(), options);
    EXPECT_GT(sheet_helpers::extent_of(sheet.groups[1]).left(),
              sheet_helpers::extent_of(sheet.groups[0]).right());
}

}  // namespace
