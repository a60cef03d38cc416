// SPDX-License-Identifier: GPL-3.0-or-later
// How lines fade, and how the detail moves all thresholds.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "generators.h"
#include "helpers.h"
#include "laplacian_lines/precompute.h"
#include "made_up_line.h"
#include "rules/opacity.h"
#include "rules/thresholds.h"

namespace {

using namespace laplacian_lines;
using helpers::MadeUp;

LineStyle all_opaque() {
    LineStyle style = helpers::all_laplacian_lines();
    style.fading = style.end_length = style.contour_clearance = 0;
    return style;
}

/// A cylinder of radius 1 from the side: the contour is 1 − cos φ away in the picture.
TEST(Fading, MeasuresTheDistanceToContoursInThePicture) {
    const float angle = 0.1f, distance = 1 - std::cos(angle);
    const auto opacity = [&](float clearance) {
        return clearance_opacity(std::sin(angle), std::cos(angle), clearance);
    };
    EXPECT_NEAR(opacity(distance), 1, 0.01);
    EXPECT_NEAR(opacity(1.5f * distance), 1 / 3., 0.01);
    EXPECT_NEAR(opacity(2 * distance), 0, 0.01);
}

float middle_opacity(const LineSet& set) {
    return set.points.at(set.points.size() / 2).opacity;
}

TEST(Fading, RisesAboveTheThresholds) {
    const MadeUp made_up;
    const Polyline line = made_up.lines(all_opaque()).lines.at(0);
    const std::pair<double LineStyle::*, double> thresholds[] = {
        {&LineStyle::line_slope, line.slope},
        {&LineStyle::segment_slope, line.slope},
        {&LineStyle::strength_threshold, line.strength},
        {&LineStyle::shortest_line, line.length}};
    for (const auto& [threshold, value] : thresholds) {
        LineStyle style = all_opaque();
        style.fading = 0.4;
        style.*threshold = value / 1.2;
        EXPECT_NEAR(middle_opacity(made_up.lines(style)), 0.5, 1e-3);
        style.*threshold = value / 1.5;
        EXPECT_NEAR(middle_opacity(made_up.lines(style)), 1, 1e-3);
    }
}

TEST(Fading, OpenEndsRunOutOverTheGivenLength) {
    LineStyle style = all_opaque();
    style.end_length = 0.1;
    const LineSet set = MadeUp().lines(style);
    const double end = 1 / MadeUp::kDiagonal;  // local distance of the ends from the middle
    for (const LinePoint& p : set.points) {
        const double to_end = end - std::abs(p.position.y()) / MadeUp::kDiagonal;
        EXPECT_NEAR(p.opacity, std::clamp(to_end / 0.1, 0., 1.), 1e-3);
    }
}

/// At I = facing and ‖∇I‖·D = g the contour is estimated at facing²/(2g) D in the picture.
TEST(Fading, SparesTheNeighbourhoodOfContours) {
    MadeUp made_up;
    made_up.facing = 0.2;
    const double distance = 0.2 * 0.2 / (2 * MadeUp::kDiagonal);
    LineStyle style = all_opaque();
    style.shows[LineKind::Contour] = true;
    style.contour_clearance = distance / 0.75;  // half-way from fading to gone
    EXPECT_NEAR(middle_opacity(made_up.lines(style)), 0.5, 2e-2);
    style.contour_clearance = 2.1 * distance;
    EXPECT_EQ(middle_opacity(made_up.lines(style)), 0);
    style.shows[LineKind::Contour] = false;  // nothing is doubled
    EXPECT_EQ(middle_opacity(made_up.lines(style)), 1);
}

/// 1, but 0 where −v·Sv is a tenth of ‖Sv‖ or more, for the torus of radii 1 and 0.4.
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
    const auto torus = test_meshes::torus(300, 150);
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

TEST(Fading, LinesThatEndAtAContourDoNotFadeAgain) {
    const auto surface = test_meshes::bumpy_sphere(5, 0.15);
    const Field field = precompute(surface.mesh);
    const LineExtractor extractor(surface.mesh, field);
    LineStyle style = all_opaque();
    style.shows[LineKind::Contour] = true;
    style.contour_clearance = 1e-3;
    style.end_length = 0.2;
    const LineSet set =
        helpers::extract(extractor, View::orthographic(Eigen::Vector3d::UnitX()), style);
    std::size_t ends = 0;
    for (const Polyline& line : set.lines) {
        const LinePoint* points = set.points.data() + line.first;
        if (line.kind != LineKind::Laplacian || line.closed || points[0].opacity > 0) continue;
        double length = 0;
        for (std::uint32_t i = 1; i < line.count && length < 0.05 * field.scale.diagonal; ++i) {
            length += double((points[i].position - points[i - 1].position).norm());
            ends += points[i].opacity > 0.9f;
        }
    }
    EXPECT_GT(ends, 0u);
}

TEST(Detail, LeavesTheThresholdsInTheMiddle) {
    EXPECT_EQ(threshold_factor(50), 1);
    for (double detail = 1; detail <= 100; ++detail)
        EXPECT_LT(threshold_factor(detail), threshold_factor(detail - 1));
}

TEST(Detail, MovesEachThreshold) {
    const MadeUp made_up;
    const Polyline line = made_up.lines(all_opaque()).lines.at(0);
    const std::pair<double LineStyle::*, double> thresholds[] = {
        {&LineStyle::gradient_threshold, MadeUp::kDiagonal},
        {&LineStyle::segment_slope, line.slope},
        {&LineStyle::line_slope, line.slope},
        {&LineStyle::strength_threshold, line.strength},
        {&LineStyle::shortest_line, line.length}};
    for (const auto& [threshold, value] : thresholds) {
        LineStyle style = all_opaque();
        style.*threshold = 1.1 * value;
        EXPECT_FALSE(made_up.is_drawn(style));
        style.detail = 70;
        EXPECT_TRUE(made_up.is_drawn(style));
        style.*threshold = 0.9 * value;
        style.detail = 30;
        EXPECT_FALSE(made_up.is_drawn(style));
    }
}

}  // namespace
