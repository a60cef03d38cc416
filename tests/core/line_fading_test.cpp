// SPDX-License-Identifier: GPL-3.0-or-later
// How lines fade and are smoothed, and how the detail moves all thresholds.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "laplacian_lines/precompute.h"
#include "synthetic_line.h"

namespace {

using namespace laplacian_lines;
using helpers::Synthetic;

LineStyle all_opaque() {
    LineStyle style = helpers::all_laplacian_lines();
    style.fading = style.end_length = style.contour_clearance = 0;
    return style;
}

float middle_opacity(const LineSet& set) {
    return set.points.at(set.points.size() / 2).opacity;
}

TEST(Fading, RisesAboveTheThresholds) {
    const Synthetic synthetic;
    const Polyline line = synthetic.lines(all_opaque()).lines.at(0);
    const std::pair<double LineStyle::*, double> thresholds[] = {
        {&LineStyle::line_slope, line.slope},
        {&LineStyle::segment_slope, line.slope},
        {&LineStyle::strength_threshold, line.strength},
        {&LineStyle::shortest_line, line.length}};
    for (const auto& [threshold, value] : thresholds) {
        LineStyle style = all_opaque();
        style.fading = 0.4;
        style.*threshold = value / 1.2;
        EXPECT_NEAR(middle_opacity(synthetic.lines(style)), 0.5, 1e-3);
        style.*threshold = value / 1.5;
        EXPECT_NEAR(middle_opacity(synthetic.lines(style)), 1, 1e-3);
    }
}

TEST(Fading, OpenEndsRunOutOverTheGivenLength) {
    LineStyle style = all_opaque();
    style.end_length = 0.1;
    const LineSet set = Synthetic().lines(style);
    ASSERT_EQ(set.lines.size(), 1u);
    const double end = 1 / Synthetic::kDiagonal;  // of an end from the middle, in D
    for (const LinePoint& p : set.points) {
        const double to_end = end - std::abs(p.position.y()) / Synthetic::kDiagonal;
        EXPECT_NEAR(p.opacity, std::clamp(to_end / 0.1, 0., 1.), 1e-3);
    }
}

/// At I = facing and ‖∇I‖·D = g the contour is estimated at facing²/(2g) D in the picture.
TEST(Fading, SparesTheNeighbourhoodOfContours) {
    Synthetic synthetic;
    synthetic.facing = 0.2;
    const double distance = 0.2 * 0.2 / (2 * Synthetic::kDiagonal);
    LineStyle style = all_opaque();
    style.shows[LineKind::Contour] = true;
    style.contour_clearance = distance / 0.75;  // half-way from fading to gone
    EXPECT_NEAR(middle_opacity(synthetic.lines(style)), 0.5, 2e-2);
    style.contour_clearance = 2.1 * distance;
    EXPECT_EQ(middle_opacity(synthetic.lines(style)), 0);
    style.shows[LineKind::Contour] = false;  // nothing is doubled
    EXPECT_EQ(middle_opacity(synthetic.lines(style)), 1);
}

/// 1, from −v·Sv = 0 on falling to 0 at ‖v‖ ‖Sv‖/10, for the torus of radii 1 and 0.4.
float expected_contour_weight(const Eigen::Vector3d& p, const Eigen::Vector3d& v) {
    const double ring = p.head<2>().norm();
    const Eigen::Vector3d outward(p.x() / ring, p.y() / ring, 0);
    const Eigen::Vector3d along(-outward.y(), outward.x(), 0);
    const double cosine = (ring - 1) / 0.4;
    const Eigen::Vector3d normal = cosine * outward + p.z() / 0.4 * Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d across = along.cross(normal);
    const Eigen::Vector3d sv = cosine / ring * along.dot(v) * along + across.dot(v) / 0.4 * across;
    return float(std::clamp(1 + v.dot(sv) / (sv.norm() * v.norm()) / 0.1, 0., 1.));
}

/// The surface hides them there, but only just.
TEST(Fading, ContoursThinOutWhereTheSurfaceIsConcaveAlongTheView) {
    const auto torus = test_meshes::torus(240, 120);
    const Field field = precompute(torus.mesh);
    const LineExtractor extractor(torus.mesh, field);
    const Eigen::Vector3d direction = Eigen::Vector3d(0, -2, 1).normalized();
    const LineSet set =
        helpers::extract(extractor, View::orthographic(direction), helpers::all_contours());
    std::size_t thin = 0, full = 0;
    for (const LinePoint& point : set.points) {
        const float expected = expected_contour_weight(point.position.cast<double>(), direction);
        EXPECT_NEAR(point.weight, expected, 0.2);  // along the line it is smoothed
        EXPECT_EQ(point.opacity, 1);
        thin += point.weight == 0;
        full += point.weight == 1;
    }
    EXPECT_GT(thin, set.points.size() / 20);
    EXPECT_GT(full, set.points.size() / 2);
}

TEST(Detail, MovesEachThreshold) {
    const Synthetic synthetic;
    const Polyline line = synthetic.lines(all_opaque()).lines.at(0);
    const std::pair<double LineStyle::*, double> thresholds[] = {
        {&LineStyle::gradient_threshold, Synthetic::kDiagonal},
        {&LineStyle::segment_slope, line.slope},
        {&LineStyle::line_slope, line.slope},
        {&LineStyle::strength_threshold, line.strength},
        {&LineStyle::shortest_line, line.length}};
    for (const auto& [threshold, value] : thresholds) {
        LineStyle style = all_opaque();
        style.*threshold = 1.1 * value;
        EXPECT_FALSE(synthetic.is_drawn(style));
        style.detail = 70;
        EXPECT_TRUE(synthetic.is_drawn(style));
        style.*threshold = 0.9 * value;
        style.detail = 30;
        EXPECT_FALSE(synthetic.is_drawn(style));
    }
}

TEST(Detail, DrawsFaintLinesInFull) {
    const Synthetic synthetic;
    LineStyle style = all_opaque();
    style.full_slope = 20 * double(synthetic.lines(style).lines.at(0).slope);
    const auto most = [&](double detail) {
        style.detail = detail;
        float weight = 0;
        for (const LinePoint& point : synthetic.lines(style).points)
            weight = std::max(weight, point.weight);
        return weight;
    };
    EXPECT_LT(most(50), 0.5f);
    EXPECT_EQ(most(100), 1);
    EXPECT_LE(most(20), most(50));
}

LineSet jittered_lines(double smoothing, const char* name = "torus_jittered") {
    const TriangleMesh& mesh = test_meshes::mesh_named(name).mesh;
    const LineExtractor extractor(mesh, precompute(mesh));
    LineStyle style = helpers::all_crossings();
    style.line_smoothing = smoothing;
    return helpers::extract(extractor, View::perspective({3, 2, 4}), style);
}

/// Squares of second differences.
double roughness(const LineSet& set) {
    double sum = 0;
    for (const Polyline& line : set.lines)
        for (std::uint32_t i = line.first + 1; i + 1 < line.first + line.count; ++i)
            sum += (set.points[i - 1].position - 2 * set.points[i].position +
                    set.points[i + 1].position)
                       .squaredNorm();
    return sum;
}

TEST(LineSmoothing, MakesLinesSmoother) {
    EXPECT_LT(roughness(jittered_lines(1.2)), roughness(jittered_lines(0)) / 4);
    EXPECT_LT(roughness(jittered_lines(3)), roughness(jittered_lines(1.2)) / 2);
}

TEST(LineSmoothing, KeepsTheLinesAndTheirEnds) {
    std::size_t closed = 0, open = 0;
    for (const char* name : {"torus_jittered", "hills"}) {
        const LineSet rough = jittered_lines(0, name), smooth = jittered_lines(2, name);
        ASSERT_EQ(smooth.lines.size(), rough.lines.size());
        for (std::size_t i = 0; i < rough.lines.size(); ++i) {
            const Polyline &a = rough.lines[i], &b = smooth.lines[i];
            ASSERT_EQ(a.count, b.count);
            EXPECT_EQ(a.length, b.length);  // tests and strengths are those of the crossings
            const auto ends = [&](const LineSet& set) {
                return std::pair{set.points[a.first].position,
                                 set.points[a.first + a.count - 1].position};
            };
            ++(a.closed ? closed : open);
            if (a.closed) {
                EXPECT_EQ(ends(smooth).first, ends(smooth).second);
                EXPECT_NE(ends(smooth).first, ends(rough).first);
            } else {
                EXPECT_LT((ends(smooth).first - ends(rough).first).norm(), 1e-5);  // rounding
                EXPECT_LT((ends(smooth).second - ends(rough).second).norm(), 1e-5);
            }
        }
    }
    EXPECT_GT(closed, 0u);
    EXPECT_GT(open, 0u);
}

TEST(LineSmoothing, LeavesStraightLinesStraight) {
    LineStyle style = helpers::all_laplacian_lines();
    style.line_smoothing = 3;
    const LineSet set = Synthetic().lines(style);
    ASSERT_EQ(set.lines.size(), 1u);
    for (const LinePoint& p : set.points)
        EXPECT_NEAR(p.position.x(), Synthetic().offset, 1e-6);
}

}  // namespace
