// SPDX-License-Identifier: GPL-3.0-or-later
// Ridges and valleys: the crest lines of convex and concave edges.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "helpers.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace laplacian_lines;

const View kView = View::perspective({3, 2, 4});

LineStyle only_ridges() {
    LineStyle style = helpers::all_crossings();
    style.shows[LineKind::Laplacian] = style.shows[LineKind::Contour] = false;
    style.shows[LineKind::Ridge] = true;
    style.fading = 0;
    style.ridge_angle = 20;
    return style;
}

LineSet ridges(const TriangleMesh& mesh, const LineStyle& style) {
    return helpers::extract(LineExtractor(mesh, precompute(mesh)), kView, style);
}

LineSet crests_from_above(const TriangleMesh& mesh, LineKind kind) {
    LineStyle style = helpers::only(kind);
    style.fading = 0;
    style.ridge_angle = 10;
    return helpers::extract(LineExtractor(mesh, precompute(mesh)),
                            View::orthographic(Eigen::Vector3d::UnitZ()), style);
}

constexpr double kRadius = 0.15;

const TriangleMesh& rounded_cube() {
    static const TriangleMesh mesh = test_meshes::rounded_cube(80, kRadius);
    return mesh;
}

/// Which of the twelve edges a point is on, from 0; −1 near a corner or on none.
int edge_of(const Eigen::Vector3f& p) {
    for (int axis = 0; axis < 3; ++axis) {
        const float u = p[(axis + 1) % 3], v = p[(axis + 2) % 3];
        if (std::abs(p[axis]) < 0.7 && std::abs(u) > 0.8 && std::abs(v) > 0.8)
            return 4 * axis + 2 * (u > 0) + (v > 0);
    }
    return -1;
}

TEST(Ridges, FollowTheMiddleOfRoundedEdges) {
    const LineSet lines = ridges(rounded_cube(), only_ridges());
    const double middle = 1 - kRadius + kRadius / std::sqrt(2.);
    std::set<int> edges;
    for (const LinePoint& p : lines.points) {
        const int edge = edge_of(p.position);
        if (edge < 0) continue;
        edges.insert(edge);
        for (int k : {1, 2})
            EXPECT_NEAR(std::abs(p.position[(edge / 4 + k) % 3]), middle, 0.025);
    }
    EXPECT_EQ(edges.size(), 12u);
    for (const Polyline& line : lines.lines) {
        EXPECT_EQ(line.kind, LineKind::Ridge);
        EXPECT_FALSE(describe(line.kind).bounds_form);
    }
}

/// Median of the points on edges: near the ends of an edge it turns less.
double median_angle(const LineSet& lines) {
    std::vector<double> angles;
    for (const LinePoint& p : lines.points)
        if (edge_of(p.position) >= 0) angles.push_back(p.gradient);
    if (angles.empty()) return 0;
    std::nth_element(angles.begin(), angles.begin() + angles.size() / 2, angles.end());
    return angles[angles.size() / 2];
}

/// [−1, 1]³ with edges of this radius in eight strips as long as they, as CAD programs write it.
TriangleMesh rounded_box(double radius) {
    constexpr int kStrips = 8, kPoints = kStrips + 1;
    const double middle = 1 - radius;
    TriangleMesh box = test_meshes::grid_mesh(
        {4 * kPoints, 2 * kPoints - 1, true, false}, [&](double u, double v) {
            const int i = int(std::lround(u * 4 * kPoints)), corner = i / kPoints,
                      ring = int(std::lround(v * (2 * kPoints - 1))), upper = ring / kPoints;
            const double turn = M_PI / 2 / kStrips,
                         around = turn * (kStrips * corner + i % kPoints),
                         up = turn * (ring % kPoints - (upper ? 0 : kStrips));
            const Eigen::Vector3d centre(corner == 0 || corner == 3 ? middle : -middle,
                                         corner < 2 ? middle : -middle, upper ? middle : -middle);
            return Eigen::Vector3d(
                centre + radius * Eigen::Vector3d(std::cos(up) * std::cos(around),
                                                  std::cos(up) * std::sin(around), std::sin(up)));
        });
    for (const double z : {-1., 1.}) {
        const auto first = std::uint32_t(box.positions.size());
        for (const double x : {-middle, middle})
            for (const double y : {-middle, middle})
                box.positions.push_back({x, z * y, z});
        box.triangles.push_back({first, first + 2, first + 1});
        box.triangles.push_back({first + 1, first + 2, first + 3});
    }
    return box;
}

TEST(Ridges, FollowRoundedEdgesOfCadMeshes) {
    for (const double radius : {0.03, 0.06}) {
        const LineSet lines = crests_from_above(rounded_box(radius), LineKind::Ridge);
        EXPECT_NEAR(helpers::total_length(lines), 12 * 2 * (1 - radius) / std::sqrt(12.), 1e-4);
    }
}

/// A narrow edge turns by all of its angle, whatever triangles it is made of; less where normals
/// are smoothed over more than 1 % of D.
TEST(Ridges, HaveTheSameAngleAtAnyResolution) {
    for (const auto& [cells, most_missing] : {std::pair(40, 7), {80, 1}, {160, 1}}) {
        const LineSet lines = ridges(test_meshes::rounded_cube(cells, 0.04), only_ridges());
        std::set<int> edges;
        for (const LinePoint& p : lines.points)
            edges.insert(edge_of(p.position));
        edges.erase(-1);
        EXPECT_EQ(edges.size(), 12u) << cells;
        EXPECT_LT(median_angle(lines), 91) << cells;
        EXPECT_GT(median_angle(lines), 90 - most_missing) << cells;
    }
}

TEST(Ridges, NeedTheirAngle) {
    LineStyle style = only_ridges();
    const LineSet all = ridges(rounded_cube(), style);
    float most = 0;
    for (const LinePoint& p : all.points)
        most = std::max(most, p.gradient);
    style.ridge_angle = 1.01 * most;
    EXPECT_TRUE(ridges(rounded_cube(), style).lines.empty());
    style.ridge_angle = 45;
    style.fading = 0.5;
    const LineSet faded = ridges(rounded_cube(), style);
    ASSERT_FALSE(faded.lines.empty());
    for (const LinePoint& p : faded.points)
        EXPECT_NEAR(p.opacity, std::clamp((p.gradient / 22.5 - 1) / 2.5, 0., 1.), 1e-3);
    style.shows[LineKind::Ridge] = false;
    EXPECT_TRUE(ridges(rounded_cube(), style).lines.empty());
}

/// Two slopes that meet at y = 0 and turn there by so many degrees: `most` at x = 0, nothing at
/// x = 1, in proportion between.
TriangleMesh fading_edge(double most) {
    return test_meshes::grid_mesh({160, 160}, [&](double u, double v) {
        const double y = v - 0.5, slope = std::tan(most * (1 - u) / 2 * M_PI / 180);
        return Eigen::Vector3d(u, y, -slope * std::sqrt(y * y + 0.01 * 0.01));
    });
}

/// Down to half of the angle, and not where there is nothing sharper.
TEST(Ridges, GoOnWhereTheyAreWeaker) {
    const auto reach = [&](double most) {
        float reach = 0;
        for (const LinePoint& p : ridges(fading_edge(most), only_ridges()).points)
            reach = std::max(reach, p.position.x());
        return reach;
    };
    EXPECT_NEAR(reach(40), 0.75, 0.04);  // there it turns by 10°
    EXPECT_EQ(reach(18), 0);
}

/// Neither round forms nor grooves have any.
TEST(Ridges, AreOnlyWhereOneConvexCurvatureRules) {
    LineStyle style = only_ridges();
    style.ridge_angle = 10;
    // 2 % of D thick: 4 % of D are more than half a turn around it
    const TriangleMesh ring = test_meshes::grid_mesh({540, 16, true, true}, [](double u, double v) {
        const double a = 2 * M_PI * u, b = 2 * M_PI * v, r = 1 + 0.03 * std::cos(b);
        return Eigen::Vector3d(r * std::cos(a), r * std::sin(a), 0.03 * std::sin(b));
    });
    for (const TriangleMesh& mesh : {ring, test_meshes::sphere(4).mesh, test_meshes::plane(24, 0.2),
                                     test_meshes::bumpy_sphere(5, 0.15).mesh}) {
        EXPECT_TRUE(ridges(mesh, style).lines.empty());
        EXPECT_TRUE(crests_from_above(mesh, LineKind::Valley).lines.empty());
    }
    for (const LinePoint& p : ridges(test_meshes::cavity(rounded_cube()), style).points)
        EXPECT_EQ(edge_of(p.position), -1);
}

/// Seen from above, the four upright edges are on the outline.
TEST(Ridges, FadeBesideContours) {
    const LineExtractor extractor(rounded_cube(), precompute(rounded_cube()));
    const View above = View::orthographic(Eigen::Vector3d::UnitZ());
    for (const bool contours : {true, false}) {
        LineStyle style = only_ridges();
        style.shows[LineKind::Contour] = contours;
        style.contour_clearance = LineStyle().contour_clearance;
        std::size_t upright = 0, others = 0;
        const LineSet set = helpers::extract(extractor, above, style);
        for (const Polyline& line : set.lines)
            for (std::uint32_t i = line.first; i < line.first + line.count; ++i) {
                const int edge = edge_of(set.points[i].position);
                if (line.kind != LineKind::Ridge || edge < 0) continue;
                (edge / 4 == 2 ? upright : others) += set.points[i].opacity > 0.5f;
            }
        EXPECT_EQ(upright > 0, !contours);
        EXPECT_GT(others, 0u);
    }
}

/// A sharp edge inside, near the rounded one outside.
TEST(Ridges, StayWhereACreaseIsBehindTheirWall) {
    const TriangleMesh inside = test_meshes::moved(test_meshes::cube(20), {0, 0, 0}, 0.94),
                       box = test_meshes::together(rounded_cube(), test_meshes::flipped(inside));
    const LineExtractor extractor(box, precompute(box));
    LineStyle style = only_ridges();
    const auto clear_ridge = [&] {
        const LineSet set = helpers::extract(extractor, kView, style);
        std::size_t clear = 0;
        for (const Polyline& line : set.lines)
            for (std::uint32_t i = line.first; i < line.first + line.count; ++i)
                clear += line.kind == LineKind::Ridge && edge_of(set.points[i].position) >= 0 &&
                         set.points[i].opacity > 0.5f;
        return clear;
    };
    const std::size_t alone = clear_ridge();
    style.shows[LineKind::Crease] = true;
    EXPECT_GT(double(clear_ridge()), 0.98 * double(alone));
    EXPECT_GT(alone, 100u);
}

/// A plate with a wavy groove at y = 0.1 sin 3x, whose height is a function of the way across.
template <class Height>
TriangleMesh groove(const Height& height) {
    return test_meshes::grid_mesh({160, 160}, [&](double u, double v) {
        const double x = 2 * u - 1, y = 2 * v - 1;
        return Eigen::Vector3d(x, y, height(y - 0.1 * std::sin(3 * x)));
    });
}

/// Between slopes that go on to the borders.
TriangleMesh wide_groove() {
    return groove([](double y) { return 0.3 * std::sqrt(y * y + 0.03 * 0.03); });
}

/// In a plane; 3 % of D wide.
TriangleMesh narrow_groove() {
    return groove([](double y) { return -0.02 * std::exp(-y * y / (2 * 0.02 * 0.02)); });
}

TEST(Valleys, FollowTheBottomsOfGrooves) {
    for (const TriangleMesh& mesh : {wide_groove(), narrow_groove()}) {
        const LineSet lines = crests_from_above(mesh, LineKind::Valley);
        ASSERT_FALSE(lines.lines.empty());
        for (const LinePoint& p : lines.points)
            EXPECT_NEAR(p.position.y(), 0.1 * std::sin(3 * p.position.x()), 0.01);
        EXPECT_NEAR(helpers::total_length(lines), 0.722, 0.01);  // about ∫√(1 + (.3 cos 3x)²)dx/√8
        for (const Polyline& line : lines.lines)
            EXPECT_EQ(line.kind, LineKind::Valley);
        EXPECT_TRUE(crests_from_above(mesh, LineKind::Ridge).lines.empty());
    }
}

TEST(Valleys, HaveTheRidgesOfTheOtherSide) {
    for (const TriangleMesh& mesh : {wide_groove(), test_meshes::hills(80).mesh}) {
        const TriangleMesh other = test_meshes::flipped(mesh);
        const LineSet valleys = crests_from_above(mesh, LineKind::Valley),
                      ridges = crests_from_above(other, LineKind::Ridge);
        ASSERT_FALSE(ridges.lines.empty());
        for (const LinePoint& p : ridges.points)
            EXPECT_LT(helpers::distance_to_lines(p.position.cast<double>(), valleys), 1e-3);
    }
}

}  // namespace
