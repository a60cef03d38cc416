// SPDX-License-Identifier: GPL-3.0-or-later
// What each threshold keeps and drops, mostly on a plane with a made-up field, whose only line has
// known gradient, slope, facing, length and strength.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "laplacian_lines/precompute.h"
#include "made_up_line.h"

namespace {

using namespace laplacian_lines;
using helpers::extract;
using helpers::MadeUp;

TEST(MadeUpLine, HasTheMeasuresThatItWasMadeWith) {
    MadeUp made_up;
    made_up.gradient = -1.5;
    made_up.slope = 3;
    made_up.kernel_size = 0.5;
    const LineSet set = made_up.lines(helpers::all_laplacian_lines());
    ASSERT_EQ(set.lines.size(), 1u);
    const Polyline& line = set.lines[0];
    const double d = MadeUp::kDiagonal;
    EXPECT_EQ(line.kind, LineKind::Laplacian);
    EXPECT_FALSE(line.closed);
    EXPECT_NEAR(line.length, 2 / d, 1e-5);
    EXPECT_NEAR(line.strength, 1.5 * 2, 1e-4);  // Eq. 4: ‖∇I‖ D · length / D
    EXPECT_NEAR(line.slope, 3 * 0.125, 1e-4);
    EXPECT_EQ(set.segment_count(), line.count - 1);
    for (const LinePoint& p : set.points) {
        EXPECT_NEAR(p.gradient, 1.5 * d, 1e-4);
        EXPECT_NEAR(p.position.x(), made_up.offset, 1e-6);
    }
}

/// Just below the line's value a threshold keeps it, just above it drops it.
void expect_threshold(const MadeUp& made_up, double LineStyle::*threshold, double value) {
    LineStyle style = helpers::all_laplacian_lines();
    style.*threshold = 0.999 * value;
    EXPECT_TRUE(made_up.is_drawn(style));
    style.*threshold = 1.001 * value;
    EXPECT_FALSE(made_up.is_drawn(style));
}

TEST(Thresholds, Gradient) {
    MadeUp made_up;
    made_up.gradient = -0.7;
    expect_threshold(made_up, &LineStyle::gradient_threshold, 0.7 * MadeUp::kDiagonal);
}

TEST(Thresholds, Strength) {
    MadeUp made_up;
    made_up.gradient = -0.7;
    expect_threshold(made_up, &LineStyle::strength_threshold, 0.7 * 2);
}

TEST(Thresholds, Slopes) {
    MadeUp made_up;
    made_up.slope = 2;
    made_up.kernel_size = 0.4;
    expect_threshold(made_up, &LineStyle::segment_slope, 2 * 0.064);
    expect_threshold(made_up, &LineStyle::line_slope, 2 * 0.064);
}

TEST(Thresholds, ShortestLine) {
    expect_threshold(MadeUp(), &LineStyle::shortest_line, 2 / MadeUp::kDiagonal);
}

TEST(Thresholds, LeastFacing) {
    for (double facing : {0.8, 0.3, 0.05}) {
        MadeUp made_up;
        made_up.facing = facing;
        expect_threshold(made_up, &LineStyle::least_facing, facing);
    }
    MadeUp back;
    back.facing = -0.4;
    LineStyle style = helpers::all_laplacian_lines();
    style.least_facing = -0.41;
    EXPECT_TRUE(back.is_drawn(style));
    style.least_facing = -0.39;
    EXPECT_FALSE(back.is_drawn(style));
}

TEST(Thresholds, LeastFacingOfMinusOneShowsTheVeryBack) {
    MadeUp back;
    back.facing = -1;
    EXPECT_TRUE(back.is_drawn(helpers::all_laplacian_lines()));
}

TEST(Thresholds, PhantomsAreCrossingsWhereTheGradientIsSmallest) {
    LineStyle style = helpers::all_laplacian_lines();
    style.reject_phantoms = true;
    MadeUp edge, phantom;
    phantom.gradient = 1;
    EXPECT_TRUE(edge.is_drawn(style));
    EXPECT_FALSE(phantom.is_drawn(style));
    style.reject_phantoms = false;
    EXPECT_TRUE(phantom.is_drawn(style));
}

TEST(Weights, GrowFromZeroToOneOverTheFullSlope) {
    LineStyle style = helpers::all_laplacian_lines();
    style.segment_slope = 1;
    style.full_slope = 2;
    for (const auto& [slope, weight] : {std::pair(1.1, 0.05), {2.0, 0.5}, {3.0, 1.0}, {9.0, 1.0}}) {
        MadeUp made_up;
        made_up.slope = slope;
        const LineSet lines = made_up.lines(style);
        ASSERT_EQ(lines.lines.size(), 1u);
        for (const LinePoint& p : lines.points)
            EXPECT_NEAR(p.weight, weight, 1e-3);
    }
}

TEST(Weights, OfContoursAreFull) {
    const auto& torus = test_meshes::mesh_named("torus_jittered").mesh;
    const LineSet lines = extract(LineExtractor(torus, precompute(torus)),
                                  View::perspective({3, 2, 4}), helpers::all_contours());
    ASSERT_FALSE(lines.points.empty());
    for (const LinePoint& p : lines.points)
        EXPECT_EQ(p.weight, 1.f);
    for (const Polyline& line : lines.lines)
        EXPECT_EQ(line.slope, 0.f);
}

/// Around z, from the side: two straight lines with ‖∇I‖ = 1/R, across which ΔI has the slope 1/R³.
TEST(Cylinder, StrengthAndSlopeAreAsComputedByHand) {
    const test_meshes::TestMesh& cylinder = test_meshes::mesh_named("cylinder");
    PrecomputeOptions options;
    options.kernel_size = 0.2;
    const Field field = precompute(cylinder.mesh, options);
    const LineSet set = extract(LineExtractor(cylinder.mesh, field),
                                View::orthographic({1, 0.07, 0}), helpers::all_laplacian_lines());
    ASSERT_EQ(set.lines.size(), 2u);
    const double effective_size =
        std::sqrt(0.04 + field.scale.normal_sigma * field.scale.normal_sigma / 2);
    for (const Polyline& line : set.lines) {
        EXPECT_NEAR(line.length * field.scale.diagonal, 2, 0.03);
        EXPECT_NEAR(line.strength, 2, 0.03);
        EXPECT_NEAR(line.slope, std::pow(effective_size, 3), 0.05 * std::pow(effective_size, 3));
    }
}

class Monotone : public testing::TestWithParam<double LineStyle::*> {};

TEST_P(Monotone, HigherThresholdsNeverGiveMoreLines) {
    const auto surface = test_meshes::bumpy_sphere(5, 0.15);
    const LineExtractor extractor(surface.mesh, precompute(surface.mesh));
    for (const View& view : helpers::random_views(surface.mesh, 6)) {
        LineStyle style = helpers::all_crossings();
        double first = helpers::total_length(extract(extractor, view, style)), previous = first;
        for (double threshold = 0.005; threshold < 50; threshold *= 1.7) {
            style.*GetParam() = GetParam() == &LineStyle::least_facing
                                    ? std::clamp(std::log(threshold) / 4, -1.0, 1.0)
                                    : std::min(threshold, 9.9);
            const double length = helpers::total_length(extract(extractor, view, style));
            EXPECT_LE(length, previous * (1 + 1e-5)) << threshold;
            previous = length;
        }
        EXPECT_LT(previous, 0.9 * first);
    }
}

INSTANTIATE_TEST_SUITE_P(Thresholds, Monotone,
                         testing::Values(&LineStyle::gradient_threshold,
                                         &LineStyle::strength_threshold, &LineStyle::segment_slope,
                                         &LineStyle::line_slope, &LineStyle::shortest_line,
                                         &LineStyle::shortest_contour, &LineStyle::least_facing));

TEST(Kinds, AreDrawnAsAsked) {
    const auto& bumpy = test_meshes::mesh_named("bumpy_sphere").mesh;
    const LineExtractor extractor(bumpy, precompute(bumpy));
    const View view = View::perspective({3, 2, 4});
    const auto count = [&](bool laplacian, bool contours, LineKind kind) {
        LineStyle style;
        style.shows[LineKind::Laplacian] = laplacian;
        style.shows[LineKind::Contour] = contours;
        std::size_t n = 0;
        for (const Polyline& line : extract(extractor, view, style).lines)
            n += line.kind == kind;
        return n;
    };
    EXPECT_GT(count(true, true, LineKind::Laplacian), 0u);
    EXPECT_GT(count(true, true, LineKind::Contour), 0u);
    EXPECT_EQ(count(true, false, LineKind::Contour), 0u);
    EXPECT_EQ(count(false, true, LineKind::Laplacian), 0u);
    EXPECT_EQ(count(false, false, LineKind::Laplacian) + count(false, false, LineKind::Contour),
              0u);
}

TEST(Kinds, ContoursAskOnlyForTheirLength) {
    const auto& torus = test_meshes::mesh_named("torus").mesh;
    const LineExtractor extractor(torus, precompute(torus));
    const View view = View::perspective({3, 2, 4});
    LineStyle style = helpers::all_contours();
    const LineSet expected = extract(extractor, view, style);
    style.gradient_threshold = style.strength_threshold = style.segment_slope = 1e6;
    style.line_slope = 1e6;
    style.shortest_line = 10;
    style.least_facing = 1;
    style.reject_phantoms = true;
    EXPECT_TRUE(helpers::same_lines(expected, extract(extractor, view, style)));
    style.shortest_contour = 10;
    EXPECT_TRUE(extract(extractor, view, style).lines.empty());
}

}  // namespace
