// SPDX-License-Identifier: GPL-3.0-or-later
#include "sections/half_section.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "laplacian_lines/error.h"
#include "made_sheets.h"
#include "sections/wall_area.h"
#include "thrown_vessel.h"

using namespace line_drawing;
using Eigen::Vector2d;
using Eigen::Vector3d;
using laplacian_lines::TriangleMesh;
using made_sheets::layerOf;
using made_sheets::painterPath;

namespace {

laplacian_lines::TriangleMesh smallVessel(double relief = 1) {
    test_meshes::VesselShape shape;
    shape.rings = 200;
    shape.columns = 120;
    shape.relief = relief;
    return test_meshes::thrown_vessel(shape);
}

/// Something on one side that shifts the bounding box.
void addHandle(laplacian_lines::TriangleMesh& mesh) {
    laplacian_lines::TriangleMesh handle = test_meshes::torus(60, 30).mesh;
    for (Vector3d& p : handle.positions)
        p = Vector3d(100, 100, 0) + 25 * p;
    test_meshes::append(mesh, handle);
}

SheetOptions vesselOptions() {
    SheetOptions options;
    options.views = parseViews("vessel", UpAxis::Y);
    options.paper = "fit";
    options.scale = 1;
    options.strokes = StrokeStyle::Plain;
    options.wall = WallStyle::Filled;
    return options;
}

TEST(Clipping, CutsTrianglesAlongThePlane) {
    const auto half = clip(made_sheets::cubeOf100(), {Vector3d(1, 0, 0), 13});
    double area = 0;
    for (const auto& t : half.triangles) {
        const Vector3d a = half.positions[t[0]];
        area += (half.positions[t[1]] - a).cross(half.positions[t[2]] - a).norm() / 2;
        for (const std::uint32_t v : t)
            EXPECT_GE(half.positions[v].x(), 13 - 1e-9);
    }
    EXPECT_NEAR(area, 100 * 100 + 4 * 37 * 100, 1e-6);
}

TEST(Clipping, KeepsPartsOfLinesThatEndOnThePlane) {
    const std::vector<Cut> square = {{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 0}}};
    const auto parts = clip(square, {Vector3d(-1, 0, 0), -1});  // x <= 1, which holds both ends
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(parts[0].front(), Vector3d(1, 2, 0));
    EXPECT_EQ(parts[0].back(), Vector3d(1, 0, 0));
    EXPECT_EQ(parts[0].size(), 4u);
    EXPECT_EQ(clip(square, {Vector3d(1, 0, 0), -1})[0], square[0]);
    EXPECT_TRUE(clip(square, {Vector3d(1, 0, 0), 3}).empty());
    EXPECT_TRUE(clipLoop(square[0], {Vector3d(1, 0, 0), 3}).empty());
    EXPECT_EQ(clipLoop(square[0], {Vector3d(1, 0, 0), 1}).size(), 5u);
}

TEST(WallArea, TakesAwayWhatIsInside) {
    const auto square = [](double half) {
        return std::vector<Vector2d>{
            {-half, -half}, {half, -half}, {half, half}, {-half, half}, {-half, -half}};
    };
    const WallArea area({square(5), square(2)});
    EXPECT_TRUE(area.contains({3, 0}));
    EXPECT_FALSE(area.contains({0, 0}));
    EXPECT_FALSE(area.contains({6, 0}));
    EXPECT_FALSE(area.contains({0, 9}));
    DrawnLine line{LineClass::Inner, false, {}};
    for (int x = -10; x <= 10; ++x)
        line.points.push_back({{double(x), 0.1}, 1});
    const auto rest = withoutPartsIn(area, {line});
    ASSERT_EQ(rest.size(), 3u);
    EXPECT_NEAR(rest[0].points.back().position.x(), -5, 1e-9);
    EXPECT_NEAR(rest[1].points.front().position.x(), -2, 1e-9);
}

TEST(WallArea, KeepsWhatIsAlongItsEdgeAndWhereALoopBegins) {
    const WallArea area({{{-5, -5}, {5, -5}, {5, 5}, {-5, 5}, {-5, -5}}});
    const auto loop = [](const std::vector<Vector2d>& places) {
        DrawnLine line{LineClass::Section, true, {}};
        for (const Vector2d& p : places)
            line.points.push_back({p, 1});
        return line;
    };
    // Half of it is inside, with common edges above and below.
    const auto rest =
        withoutPartsIn(area, {loop({{9, 0}, {9, 5}, {0, 5}, {0, -5}, {9, -5}, {9, 0}})});
    ASSERT_EQ(rest.size(), 1u);
    EXPECT_EQ(rest[0].points.front().position, Vector2d(0, -5));
    EXPECT_EQ(rest[0].points.back().position, Vector2d(0, 5));
    const DrawnLine around = loop({{9, 9}, {9, -9}, {-9, -9}, {-9, 9}, {9, 9}});
    EXPECT_TRUE(withoutPartsIn(area, {around})[0].closed);
    EXPECT_TRUE(withoutPartsIn(area, {loop({{1, 1}, {1, 0}, {0, 0}, {1, 1}})}).empty());
}

TEST(AxisFinding, IsTheAxisOfRevolutionWithAHandle) {
    auto mesh = smallVessel();
    addHandle(mesh);
    for (Vector3d& p : mesh.positions)
        p += Vector3d(1000, 7, -300);
    const VesselAxis axis = findAxis(mesh, 1);
    EXPECT_NEAR(axis.point.x(), 1000, 0.3);
    EXPECT_NEAR(axis.point.z(), -300, 0.3);
    EXPECT_GT(axis.round, 0.85);
    EXPECT_EQ(axis.rim, 1);
    EXPECT_NEAR(findAxis(made_sheets::cubeOf100(), 1).point.x(), 0, 1e-9);
}

TriangleMesh turnedAside(TriangleMesh mesh, double degrees) {
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(degrees * M_PI / 180, Vector3d::UnitX()).toRotationMatrix();
    for (Vector3d& p : mesh.positions)
        p = rotation * p;
    return mesh;
}

TriangleMesh sherdOf(const TriangleMesh& mesh, double degrees) {
    TriangleMesh part = mesh;
    part.triangles.clear();
    for (const auto& t : mesh.triangles) {
        const Vector3d& p = mesh.positions[t[0]];
        if (std::abs(std::atan2(p.z(), p.x())) < degrees / 2 * M_PI / 180)
            part.triangles.push_back(t);
    }
    return part;
}

TEST(AxisFinding, TellsHowMuchSpeaksForIt) {
    const TriangleMesh jar = smallVessel();
    EXPECT_GT(findAxis(jar, 1).round, 0.95);
    for (const double degrees : {0., 1., 4., 20.})
        EXPECT_NEAR(findAxis(turnedAside(jar, degrees), 1).lean, degrees, 0.05);
    EXPECT_NEAR(findAxis(sherdOf(turnedAside(jar, 4), 60), 1).lean, 4, 0.1);
    EXPECT_LT(findAxis(made_sheets::cubeOf100(), 1).round, 0.3);
    EXPECT_NEAR(findAxis(sherdOf(jar, 270), 1).rim, 0.75, 0.03);
    EXPECT_NEAR(findAxis(sherdOf(jar, 270), 1).round, 1, 0.05);
}

TEST(HalfSection, IsRefusedOfWhatIsNoVessel) {
    const auto draw = [](const TriangleMesh& mesh) {
        return made_sheets::sheetOf(mesh, vesselOptions());
    };
    EXPECT_THROW(draw(made_sheets::cubeOf100()), laplacian_lines::Error);
    EXPECT_THROW(draw(turnedAside(smallVessel(), 20)), laplacian_lines::Error);
    EXPECT_THROW(draw(sherdOf(smallVessel(), 60)), laplacian_lines::Error);
    SheetOptions options = vesselOptions();
    options.has_notes = true;
    const Sheet sheet = made_sheets::sheetOf(sherdOf(smallVessel(), 270), options);
    ASSERT_EQ(sheet.remarks.size(), 1);
    EXPECT_EQ(sheet.remarks[0].find("Vessel: rim 7"), 0u) << sheet.remarks[0];
    bool is_said = false;
    for (const SheetLayer& layer : sheet.groups.back().layers)
        for (const SheetText& text : layer.texts)
            is_said |= text.text.find("rim 7") != std::string::npos;
    EXPECT_TRUE(is_said);
}

TEST(HalfSection, DrawsTheWallOnTheLeftAndTheOutsideOnTheRight) {
    const Sheet sheet = made_sheets::sheetOf(smallVessel(0), vesselOptions());
    const SheetGroup& vessel = sheet.groups.at(0);
    EXPECT_EQ(vessel.key, "vessel");
    const SheetLayer& wall = layerOf(vessel, "section");
    QRectF all = made_sheets::extentOf(vessel);
    double area = 0;
    for (const SheetPath& path : wall.paths) {
        EXPECT_LE(painterPath(path.path).boundingRect().right(), all.center().x() + 0.05);
        if (path.pen_width > 0) continue;
        for (const QPolygonF& polygon : painterPath(path.path).toSubpathPolygons())
            for (int i = 1; i < polygon.size(); ++i)
                area +=
                    (polygon[i - 1].x() * polygon[i].y() - polygon[i - 1].y() * polygon[i].x()) / 2;
    }
    double expected = 0;  // of the profile, which ends on the axis
    const auto profile = test_meshes::vessel_profile(2000);
    for (std::size_t i = 1; i < profile.size(); ++i)
        expected += (profile[i - 1].x() * profile[i].y() - profile[i - 1].y() * profile[i].x()) / 2;
    EXPECT_NEAR(std::abs(area), std::abs(expected), 0.02 * std::abs(expected));
    for (const SheetPath& path : layerOf(vessel, "outline").paths)
        EXPECT_GE(painterPath(path.path).boundingRect().left(), all.center().x() - 0.05);
}

/// Along the way from `left` to `right` at this height.
double shareDrawn(const SheetGroup& view, double height, double left, double right) {
    std::vector<bool> is_drawn(100);
    for (const SheetLayer& layer : view.layers)
        for (const SheetPath& path : layer.paths)
            for (double t = 0; t <= 1; t += 1e-3) {
                const QPointF p = painterPath(path.path).pointAtPercent(t);
                const double place = (p.x() - left) / (right - left) * double(is_drawn.size());
                if (std::abs(p.y() - height) < 0.5 && place >= 0 && place < double(is_drawn.size()))
                    is_drawn[std::size_t(place)] = true;
            }
    return double(std::count(is_drawn.begin(), is_drawn.end(), true)) / double(is_drawn.size());
}

TEST(HalfSection, HasAnAxisAndLinesThroughRimAndBase) {
    const Sheet sheet = made_sheets::sheetOf(smallVessel(0), vesselOptions());
    const QRectF all = made_sheets::extentOf(sheet.groups.at(0));
    bool has_axis = false;
    for (const SheetPath& path : layerOf(sheet.groups[0], "inner").paths) {
        const QRectF box = painterPath(path.path).boundingRect();
        has_axis |= box.width() < 0.01 && std::abs(box.height() - all.height()) < 0.1 &&
                    std::abs(box.center().x() - all.center().x()) < 0.2;
    }
    EXPECT_TRUE(has_axis);
    const double middle = all.center().x();
    EXPECT_GT(shareDrawn(sheet.groups[0], all.top(), middle - 15, middle + 15), 0.95);
    EXPECT_GT(shareDrawn(sheet.groups[0], all.bottom(), middle - 15, middle + 15), 0.95);
}

TEST(HalfSection, StandsBesideAFrontView) {
    SheetOptions options = vesselOptions();
    options.views = parseViews("front,vessel", UpAxis::Y);
    const Sheet sheet = made_sheets::sheetOf(smallVessel(), options);
    EXPECT_GT(made_sheets::extentOf(sheet.groups[1]).left(),
              made_sheets::extentOf(sheet.groups[0]).right());
}

/// A closed cylinder along y, as large as the cube.
TriangleMesh drum() {
    constexpr std::uint32_t kSides = 64;
    TriangleMesh mesh;
    for (const double y : {-50., 50.})
        for (std::uint32_t i = 0; i < kSides; ++i) {
            const double angle = 2 * M_PI * i / kSides;
            mesh.positions.push_back({50 * std::cos(angle), y, -50 * std::sin(angle)});
        }
    for (std::uint32_t i = 0; i < kSides; ++i) {
        const std::uint32_t next = (i + 1) % kSides;
        mesh.triangles.push_back({i, next, next + kSides});
        mesh.triangles.push_back({i, next + kSides, i + kSides});
        if (i > 0 && next > 0) {
            mesh.triangles.push_back({0, next, i});
            mesh.triangles.push_back({kSides, i + kSides, next + kSides});
        }
    }
    return mesh;
}

TEST(HalfSection, ShowsHiddenEdgesIfWanted) {
    SheetOptions options = vesselOptions();
    TriangleMesh mesh = drum();
    auto block = made_sheets::cubeOf100();  // behind the drum, on both sides of its axis
    for (Vector3d& p : block.positions)
        p = Vector3d(0.6 * p.x(), 0.2 * p.y(), 0.2 * p.z() - 100);
    test_meshes::append(mesh, block);
    for (const bool wanted : {false, true}) {
        options.hidden = wanted ? HiddenLines::Dashed : HiddenLines::LeftOut;
        const SheetGroup view = made_sheets::sheetOf(mesh, options).groups.at(0);
        double right = 0, left = 0;
        const double middle = made_sheets::extentOf(view).center().x();
        for (const SheetPath& path : layerOf(view, "hidden").paths)
            (painterPath(path.path).boundingRect().center().x() > middle ? right : left) +=
                painterPath(path.path).length();
        // the half of the block that is hidden by the drum; on the left it is behind the wall
        EXPECT_NEAR(right, wanted ? 2 * 30 + 20 : 0, 1);
        EXPECT_EQ(left, 0);
    }
}

}  // namespace
