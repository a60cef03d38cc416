// SPDX-License-Identifier: GPL-3.0-or-later
// Contours in space: as smooth as other lines, but for what is exact.
#include "visibility/sight_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fixed/line_smoothing.h"
#include "generators.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/precompute.h"
#include "plain_sight.h"

namespace {

using namespace laplacian_lines;

/// Without exact points.
SightLine zigzag(std::size_t count, bool closed) {
    SightLine line{LineKind::Contour, closed, false, false, 0, 0, 0, {}};
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = 2 * std::acos(-1.0) * double(i) / double(count);
        const double r = 1 + 0.2 * double(i % 2);
        line.points.push_back({{r * std::cos(angle), r * std::sin(angle), 0.1 * double(i % 3)},
                               1,
                               0,
                               1,
                               std::uint32_t(i),
                               false});
    }
    if (closed) line.points.push_back(SightPoint(line.points.front()));
    return line;
}

void expect_as_smooth_positions(const SightLine& smoothed, const SightLine& original, int passes,
                                std::size_t begin, std::size_t end) {
    std::vector<LinePoint> points;
    for (std::size_t i = begin; i < end; ++i)
        points.push_back({original.points[i].position.cast<float>(), 1, 0, 1});
    Polyline whole;
    whole.count = std::uint32_t(points.size());
    whole.closed = original.closed;
    smooth_positions(whole, points.data(), passes);
    for (std::size_t i = begin; i < end; ++i)
        EXPECT_LT((smoothed.points[i].position - points[i - begin].position.cast<double>()).norm(),
                  1e-6)
            << i;
}

TEST(SightSmoothing, IsThatOfOtherLines) {
    for (const bool closed : {false, true})
        for (const std::size_t count : {3u, 4u, 11u}) {
            SightLine line = zigzag(count, closed);
            smooth_between_exact(3, line);
            expect_as_smooth_positions(line, zigzag(count, closed), 3, 0, line.points.size());
        }
}

TEST(SightSmoothing, EndsAtExactPoints) {
    SightLine original = zigzag(20, false);
    original.points[7].is_exact = true;
    SightLine line = original;
    smooth_between_exact(4, line);
    EXPECT_EQ(line.points[7].position, original.points[7].position);
    expect_as_smooth_positions(line, original, 4, 0, 8);
    expect_as_smooth_positions(line, original, 4, 7, 20);
}

TEST(SightSmoothing, LeavesLinesOfTwoPoints) {
    SightLine line = zigzag(2, false);
    smooth_between_exact(3, line);
    EXPECT_EQ(line.points[0].position, zigzag(2, false).points[0].position);
}

double largest_turn(const SightLine& line) {
    double turn = 0;
    for (std::size_t i = 2; i < line.points.size(); ++i) {
        const Eigen::Vector3d a = line.points[i - 1].position - line.points[i - 2].position,
                              b = line.points[i].position - line.points[i - 1].position;
        turn = std::max(turn, std::acos(a.normalized().dot(b.normalized())));
    }
    return turn;
}

TEST(SightSmoothing, MakesContoursInSpaceSmoothAndNotThoseInThePicture) {
    const LineVisibility visibility(test_meshes::sphere(4, 1, 0.2).mesh);
    const View view = View::orthographic({0.3, 0.2, 1});
    const auto turn_of = [&](double smoothing, bool in_picture) {
        const auto lines =
            visibility.look(view, {}, {plain_sight::edge_kinds(), smoothing, true, in_picture});
        EXPECT_EQ(lines.size(), 1u);
        return largest_turn(lines.at(0));
    };
    const double unsmoothed = turn_of(0, false);
    EXPECT_GT(unsmoothed, 0.8);
    EXPECT_LT(turn_of(1.2, false), 0.6 * unsmoothed);
    EXPECT_EQ(turn_of(1.2, true), turn_of(0, true));
}

/// Even where contours run along them.
TEST(SightSmoothing, LeavesEdgesOfTheForm) {
    const TriangleMesh mesh = test_meshes::cube(6);
    const Field field = precompute(mesh);
    const LineExtractor extractor(mesh, field);
    LineStyle style;
    style.shows = plain_sight::edge_kinds();
    const View view = View::perspective({5, 4, 3});
    ExtractionScratch scratch;
    const LineSet lines = extract_on_surface(extractor, view, style, scratch);
    const auto seen = LineVisibility(mesh).look(view, {lines}, {style.shows, 3});
    double length = 0;
    for (const SightLine& line : seen)
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            const Eigen::Vector3d& p = line.points[i].position;
            int on_faces = 0;
            for (const double x : p)
                on_faces += std::abs(std::abs(x) - 1) < 1e-9;
            EXPECT_GE(on_faces, 2) << p.transpose();
            if (i > 0) length += (p - line.points[i - 1].position).norm();
        }
    EXPECT_NEAR(length, 9 * 2, 1e-9);  // all edges but three
}

/// A smooth contour has no point where it merely passes behind another.
TEST(SightSmoothing, DoesNotDependOnWhatPassesInThePicture) {
    TriangleMesh mesh = test_meshes::sphere(3).mesh, small = test_meshes::sphere(2, 0.4).mesh;
    const View view = View::orthographic(Eigen::Vector3d::UnitZ());
    const SightOptions options{plain_sight::edge_kinds(), 1.2, false};
    const auto alone = LineVisibility(mesh).look(view, {}, options);
    for (Eigen::Vector3d& p : small.positions)
        p += Eigen::Vector3d(1, 0, -3);  // behind the outline
    test_meshes::append(mesh, small);
    const auto both = LineVisibility(mesh).look(view, {}, options);
    ASSERT_EQ(alone.size(), 1u);
    const auto same =
        std::find_if(both.begin(), both.end(), [](const SightLine& line) { return line.closed; });
    ASSERT_NE(same, both.end());
    ASSERT_EQ(same->points.size(), alone[0].points.size());
    for (const SightPoint& p : same->points)
        EXPECT_TRUE(std::any_of(
            alone[0].points.begin(), alone[0].points.end(),
            [&](const SightPoint& q) { return (p.position - q.position).norm() < 1e-9; }));
}

}  // namespace
