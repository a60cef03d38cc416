// SPDX-License-Identifier: GPL-3.0-or-later
// What LineVisibility makes of the mesh's own edges: smooth contours in space, and lines where
// surfaces run through each other, not where they touch.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "helpers.h"
#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/precompute.h"
#include "tie_views.h"

namespace {

using namespace laplacian_lines;
using namespace tie_views;
using Eigen::Vector3d;
using helpers::length_of;
using test_meshes::moved;
using test_meshes::together;

double largest_turn(const ViewLine& line) {
    double turn = 0;
    for (std::size_t i = 2; i < line.points.size(); ++i) {
        const Eigen::Vector3d a = line.points[i - 1].position - line.points[i - 2].position,
                              b = line.points[i].position - line.points[i - 1].position;
        turn = std::max(turn, std::acos(a.normalized().dot(b.normalized())));
    }
    return turn;
}

TEST(ViewLineSmoothing, MakesContoursInSpaceSmoothAndNotThoseInThePicture) {
    const LineVisibility visibility(test_meshes::sphere(4, 1, 0.2).mesh);
    const View view = View::orthographic({0.3, 0.2, 1});
    const auto turn_of = [&](double smoothing, bool in_picture) {
        const auto lines =
            visibility.visible_lines(view, {}, {edge_kinds(), smoothing, true, in_picture});
        EXPECT_EQ(lines.size(), 1u);
        return largest_turn(lines.at(0));
    };
    const double unsmoothed = turn_of(0, false);
    EXPECT_GT(unsmoothed, 0.8);
    EXPECT_LT(turn_of(1.2, false), 0.6 * unsmoothed);
    EXPECT_EQ(turn_of(1.2, true), turn_of(0, true));
}

/// Even where contours run along them.
TEST(ViewLineSmoothing, LeavesEdgesOfTheForm) {
    const TriangleMesh mesh = test_meshes::cube(6);
    const Field field = precompute(mesh);
    const LineExtractor extractor(mesh, field);
    LineStyle style;
    style.shows = edge_kinds();
    const View view = View::perspective({5, 4, 3});
    ExtractionScratch scratch;
    const LineSet lines = extract_on_surface(extractor, view, style, scratch);
    const auto seen = LineVisibility(mesh).visible_lines(view, {lines}, {style.shows, 3});
    for (const ViewLine& line : seen)
        for (const ViewLinePoint& point : line.points) {
            int on_faces = 0;
            for (const double x : point.position)
                on_faces += std::abs(std::abs(x) - 1) < 1e-9;
            EXPECT_GE(on_faces, 2) << point.position.transpose();
        }
    EXPECT_NEAR(length_of(seen), 9 * 2, 1e-9);  // all edges but three
}

/// A smooth contour has no point where another merely passes behind it.
TEST(ViewLineSmoothing, DoesNotDependOnWhatPassesInThePicture) {
    const TriangleMesh mesh = test_meshes::sphere(3).mesh,
                       small = moved(test_meshes::sphere(2, 0.4).mesh, {1, 0, -3});
    const View view = View::orthographic(Eigen::Vector3d::UnitZ());
    const VisibilityOptions options{edge_kinds(), 1.2, false};
    const auto alone = LineVisibility(mesh).visible_lines(view, {}, options);
    const auto both =  // the small one behind the outline
        LineVisibility(together(mesh, small)).visible_lines(view, {}, options);
    ASSERT_EQ(alone.size(), 1u);
    EXPECT_GT(both.size(), 1u);
    const auto same =
        std::find_if(both.begin(), both.end(), [](const ViewLine& line) { return line.closed; });
    ASSERT_NE(same, both.end());
    ASSERT_EQ(same->points.size(), alone[0].points.size());
    for (const ViewLinePoint& p : same->points)
        EXPECT_TRUE(std::any_of(
            alone[0].points.begin(), alone[0].points.end(),
            [&](const ViewLinePoint& q) { return (p.position - q.position).norm() < 1e-9; }));
}

const Vector3d kAside = {0.7, 0.6, 0.45};

TriangleMesh two_boxes(int cells, int other_cells, const Vector3d& offset,
                       const Eigen::AngleAxisd& turn = Eigen::AngleAxisd(0, Vector3d::UnitX())) {
    return test_meshes::mapped(
        together(test_meshes::cube(cells), moved(test_meshes::cube(other_cells), offset)),
        [&](Vector3d& p) { p = turn * p; });
}

/// Without extracted lines, creases are the cuts.
std::vector<ViewLine> cuts_of(const TriangleMesh& mesh, const View& view, bool has_hidden = true) {
    const LineKindSet creases = only_kinds({LineKind::Crease});
    return LineVisibility(mesh).visible_lines(view, {}, {creases, 1.2, has_hidden, false});
}

/// Of [-1, 1]³ and a copy moved by kAside: a hexagon of sides along the axes.
constexpr double kHexagon = 2 * (1.3 + 1.4 + 1.55);

TEST(SurfaceCuts, OfTwoBoxesAreAHexagon) {
    for (const View& view : views_from(special_directions(), kAside / 2, 4.5)) {
        SCOPED_TRACE(words(view));
        const auto cuts = cuts_of(two_boxes(1, 1, kAside), view);
        EXPECT_NEAR(length_of(cuts), kHexagon, 1e-6);
        for (const ViewLine& cut : cuts)
            for (const ViewLinePoint& p : cut.points) {
                EXPECT_NEAR(p.position.maxCoeff(), 1, 1e-6);
                EXPECT_NEAR((p.position - kAside).minCoeff(), -1, 1e-6);
            }
    }
}

TEST(SurfaceCuts, DoNotDependOnTheTriangles) {
    const View view = View::orthographic({0.31, -0.74, 0.59});
    const Eigen::AngleAxisd turn(0.8, Vector3d(1, 2, 3).normalized());
    for (int cells = 1; cells <= 7; ++cells)
        for (int other = 1; other <= 7; other += 2) {
            SCOPED_TRACE(testing::Message() << cells << ", " << other);
            EXPECT_NEAR(length_of(cuts_of(two_boxes(cells, other, kAside), view)), kHexagon, 1e-5);
            EXPECT_NEAR(length_of(cuts_of(two_boxes(cells, other, kAside, turn), view)), kHexagon,
                        1e-5);
        }
}

TEST(SurfaceCuts, AreHiddenAsOtherEdgesAre) {
    const TriangleMesh mesh = two_boxes(2, 3, kAside);
    EXPECT_NEAR(length_of(cuts_of(mesh, View::orthographic({1, 1.1, 1.2}), false)), 0, 1e-6);
    // Two sides of the second box emerge beside the first.
    EXPECT_NEAR(length_of(cuts_of(mesh, View::orthographic({-1, 0.2, 0.1}), false)), 1.4 + 1.55,
                1e-6);
    const auto seen = cuts_of(mesh, View::orthographic({1, -1.1, 1.2}), false);
    ASSERT_FALSE(seen.empty());
    for (const ViewLine& line : seen)
        for (const ViewLinePoint& p : line.points)
            EXPECT_NEAR(p.position.y(), -0.4, 1e-6);  // that side of the second box is in sight
}

/// As of a ball half sunk into a plate, with vertices all around at its height.
TEST(SurfaceCuts, RunAlongEdgesInTheOtherSurface) {
    const TriangleMesh mesh =
        together(test_meshes::cube(1),
                 test_meshes::stacked({{0.3, 0.3, 0}, {0.6, 0.6, 1}, {0.4, 0.4, 1.5}}));
    EXPECT_NEAR(length_of(cuts_of(mesh, View::orthographic({0.31, -0.74, 0.59}))), 4.8, 1e-6);
}

TEST(SurfaceCuts, AreNoneWhereSurfacesTouch) {
    const Vector3d touching[] = {{2, 0, 0}, {2, 0.5, 0.25}, {2, 2, 2}, {0.3, 0.7, -2}};
    for (const Vector3d& offset : touching)
        for (const int cells : {1, 3})
            for (const double angle : {0., 0.7}) {
                const Eigen::AngleAxisd turn(angle, Vector3d(3, 1, 2).normalized());
                const auto cuts = cuts_of(two_boxes(cells, 2, offset, turn),
                                          View::orthographic({0.31, -0.74, 0.59}), false);
                EXPECT_EQ(length_of(cuts), 0)
                    << offset.transpose() << ", " << cells << ", " << angle;
            }
}

}  // namespace
