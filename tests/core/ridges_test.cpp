// SPDX-License-Identifier: GPL-3.0-or-later
// Ridges: the crest lines of convex edges.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

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
    const LineExtractor extractor(mesh, precompute(mesh));
    return helpers::extract(extractor, kView, style);
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
        const int axis = edge / 4;
        for (int k : {1, 2})
            EXPECT_NEAR(std::abs(p.position[(axis + k) % 3]), middle, 0.02);
    }
    EXPECT_EQ(edges.size(), 12u);
    for (const Polyline& line : lines.lines) {
        EXPECT_EQ(line.kind, LineKind::Ridge);
        EXPECT_FALSE(describe(line.kind).is_outline);
    }
}

/// Across a fillet of radius r the surface turns by 2 √h/r within the kernel; the kernel and the
/// smoothing of the normals see a somewhat rounder one.
TEST(Ridges, KnowTheirAngle) {
    const Field field = precompute(rounded_cube());
    const double sigma = field.scale.normal_sigma, h = std::pow(field.scale.kernel_size, 2);
    const double angle = 2 * std::sqrt(h + sigma * sigma / 2) / kRadius * 180 / 3.14159265358979;
    const LineSet lines = ridges(rounded_cube(), only_ridges());
    double sum = 0, count = 0;
    for (const LinePoint& p : lines.points)
        if (edge_of(p.position) >= 0) {
            sum += p.gradient;
            ++count;
        }
    EXPECT_NEAR(sum / count, angle, 0.1 * angle);
}

TEST(Ridges, NeedTheirAngle) {
    LineStyle style = only_ridges();
    const LineSet all = ridges(rounded_cube(), style);
    const float angle = all.points.at(all.points.size() / 2).gradient;
    style.ridge_angle = 1.5 * angle;
    EXPECT_TRUE(ridges(rounded_cube(), style).lines.empty());
    style.ridge_angle = angle / 1.2;
    style.fading = 1;  // of which ridges take 0.4
    for (const LinePoint& p : ridges(rounded_cube(), style).points)
        EXPECT_NEAR(p.opacity, std::clamp(1.2 * p.gradient / angle / 0.4 - 2.5, 0., 1.), 1e-3);
    style.shows[LineKind::Ridge] = false;
    EXPECT_TRUE(ridges(rounded_cube(), style).lines.empty());
}

/// Neither round forms nor grooves have any.
TEST(Ridges, AreOnlyWhereOneConvexCurvatureRules) {
    LineStyle style = only_ridges();
    style.ridge_angle = 10;
    EXPECT_TRUE(ridges(test_meshes::mesh_named("sphere").mesh, style).lines.empty());
    EXPECT_TRUE(ridges(test_meshes::mesh_named("plane").mesh, style).lines.empty());
    TriangleMesh inside_out = rounded_cube();
    for (Triangle& t : inside_out.triangles)
        std::swap(t[0], t[1]);
    for (const LinePoint& p : ridges(inside_out, style).points)
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

TEST(Ridges, AreTheSameFromEverywhere) {
    const LineExtractor extractor(rounded_cube(), precompute(rounded_cube()));
    const LineSet lines = helpers::extract(extractor, kView, only_ridges());
    ASSERT_FALSE(lines.lines.empty());
    for (const View& view : helpers::random_views(rounded_cube(), 5))
        EXPECT_TRUE(helpers::same_lines(lines, helpers::extract(extractor, view, only_ridges())));
}

}  // namespace
