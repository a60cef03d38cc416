// SPDX-License-Identifier: GPL-3.0-or-later
// What each threshold of Laplacian lines and contours keeps and drops, mostly on a plane with a
// synthetic field, whose only line has known gradient, slope, facing, length and strength; single
// strokes; a light that is not at the eye.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "helpers.h"
#include "laplacian_lines/precompute.h"
#include "synthetic_line.h"

namespace {

using namespace laplacian_lines;
using helpers::extract;
using helpers::Synthetic;

TEST(MadeUpLine, HasTheMeasuresThatItWasMadeWith) {
    Synthetic synthetic;
    synthetic.gradient = -1.5;
    synthetic.slope = 3;
    synthetic.kernel_size = 0.5;
    const LineSet set = synthetic.lines(helpers::all_laplacian_lines());
    ASSERT_EQ(set.lines.size(), 1u);
    const Polyline& line = set.lines[0];
    const double d = Synthetic::kDiagonal;
    EXPECT_EQ(line.kind, LineKind::Laplacian);
    EXPECT_FALSE(line.closed);
    EXPECT_NEAR(line.length, 2 / d, 1e-5);
    EXPECT_NEAR(line.strength, 1.5 * 2, 1e-4);  // Eq. 4: ‖∇I‖ D · length / D
    EXPECT_NEAR(line.slope, 3 * 0.125, 1e-4);
    EXPECT_EQ(set.segment_count(), line.count - 1);
    for (const LinePoint& p : set.points) {
        EXPECT_NEAR(p.gradient, 1.5 * d, 1e-4);
        EXPECT_NEAR(p.position.x(), synthetic.offset, 1e-6);
    }
}

/// Just below the line's value a threshold keeps it, just above it drops it.
void expect_threshold(const Synthetic& synthetic, double LineStyle::*threshold, double value) {
    LineStyle style = helpers::all_laplacian_lines();
    style.*threshold = 0.999 * value;
    EXPECT_TRUE(synthetic.is_drawn(style));
    style.*threshold = 1.001 * value;
    EXPECT_FALSE(synthetic.is_drawn(style));
}

TEST(Thresholds, OfGradientStrengthSlopesAndLength) {
    Synthetic synthetic;
    synthetic.gradient = -0.7;
    synthetic.slope = 2;
    synthetic.kernel_size = 0.4;
    for (const auto& [threshold, value] :
         {std::pair(&LineStyle::gradient_threshold, 0.7 * Synthetic::kDiagonal),
          {&LineStyle::strength_threshold, 0.7 * 2},
          {&LineStyle::segment_slope, 2 * 0.064},
          {&LineStyle::line_slope, 2 * 0.064},
          {&LineStyle::shortest_line, 2 / Synthetic::kDiagonal}}) {
        SCOPED_TRACE(value);
        expect_threshold(synthetic, threshold, value);
    }
}

TEST(Thresholds, LeastFacing) {
    for (double facing : {0.8, 0.3, 0.05}) {
        Synthetic synthetic;
        synthetic.facing = facing;
        expect_threshold(synthetic, &LineStyle::least_facing, facing);
    }
    Synthetic back;
    back.facing = -0.4;
    LineStyle style = helpers::all_laplacian_lines();
    style.least_facing = -0.41;
    EXPECT_TRUE(back.is_drawn(style));
    style.least_facing = -0.39;
    EXPECT_FALSE(back.is_drawn(style));
}

TEST(Thresholds, PhantomsAreCrossingsWhereTheGradientIsSmallest) {
    LineStyle style = helpers::all_laplacian_lines();
    Synthetic edge, phantom;
    phantom.gradient = 1;
    for (const bool whole : {false, true})
        for (const bool rejects : {true, false}) {
            style.whole_lines = whole;
            style.reject_phantoms = rejects;
            EXPECT_TRUE(edge.is_drawn(style));
            EXPECT_EQ(phantom.is_drawn(style), !rejects);
        }
}

TEST(Weights, GrowFromZeroToOneOverTheFullSlope) {
    LineStyle style = helpers::all_laplacian_lines();
    style.segment_slope = 1;
    style.full_slope = 2;
    for (const auto& [slope, weight] : {std::pair(1.1, 0.05), {2.0, 0.5}, {3.0, 1.0}, {9.0, 1.0}}) {
        Synthetic synthetic;
        synthetic.slope = slope;
        const LineSet lines = synthetic.lines(style);
        ASSERT_EQ(lines.lines.size(), 1u);
        for (const LinePoint& p : lines.points)
            EXPECT_NEAR(p.weight, weight, 1e-3);
    }
}

TEST(Kinds, ContoursAskOnlyForTheirLength) {
    const auto& torus = test_meshes::mesh_named("torus").mesh;
    const LineExtractor extractor(torus, precompute(torus));
    const View view = View::perspective({3, 2, 4});
    LineStyle style = helpers::all_contours();
    const LineSet expected = extract(extractor, view, style);
    ASSERT_FALSE(expected.lines.empty());
    style.gradient_threshold = style.strength_threshold = style.segment_slope = 1e6;
    style.line_slope = 1e6;
    style.shortest_line = 10;
    style.least_facing = 1;
    style.reject_phantoms = true;
    EXPECT_TRUE(helpers::same_lines(expected, extract(extractor, view, style)));
    style.shortest_contour = 10;
    EXPECT_TRUE(extract(extractor, view, style).lines.empty());
}

LineStyle single_strokes() {
    LineStyle style = helpers::all_laplacian_lines();
    style.single_strokes = true;
    style.fading = style.end_length = 0;
    return style;
}

const Eigen::Vector3d kRight(0.3, 0, 1), kLeft(-0.3, 0, 1);

bool is_drawn(double gradient, const View& view) {
    Synthetic synthetic;
    synthetic.gradient = gradient;
    return !synthetic.lines(single_strokes(), view).lines.empty();
}

/// l·S l = 2 gradient l_x l_z.
TEST(SingleStrokes, AreWhereTheSurfaceIsConcaveTowardsTheEye) {
    EXPECT_TRUE(is_drawn(-1, View::orthographic(kRight)));
    EXPECT_FALSE(is_drawn(-1, View::orthographic(kLeft)));
    EXPECT_FALSE(is_drawn(1, View::orthographic(kRight)));
    EXPECT_TRUE(is_drawn(1, View::orthographic(kLeft)));
}

TEST(SingleStrokes, FollowALightElsewhere) {
    View view = Synthetic::above();
    view.light = kRight;
    EXPECT_TRUE(is_drawn(-1, view));
    view.light = kLeft;
    EXPECT_FALSE(is_drawn(-1, view));
}

/// Opacity rises from 0 where −l·S l/(‖w‖‖S l‖), w the tangential part of l, is −fading/4, to 1
/// where it is fading/2.
TEST(SingleStrokes, FadeInFromConvexToConcave) {
    const Eigen::Vector3d l = Eigen::Vector3d(0, 0.6, 0.8);
    for (const double trace : {0.08, 0.03, -0.05, -0.2, -0.4}) {
        Synthetic synthetic;
        synthetic.trace = trace;
        const double measure = -trace * l.y() / std::hypot(l.z(), trace * l.y());
        const double expected = std::clamp((measure + 0.1) / 0.3, 0., 1.);
        for (const bool at_eye : {true, false}) {
            View view = at_eye ? View::orthographic(l) : Synthetic::above();
            if (!at_eye) view.light = l;
            LineStyle style = single_strokes();
            style.fading = 0.4;
            const LineSet set = synthetic.lines(style, view);
            ASSERT_EQ(set.lines.size(), 1u);
            EXPECT_NEAR(set.points[set.points.size() / 2].opacity, expected, 1e-3);
        }
    }
}

TEST(SingleStrokes, ArePartOfThePapersLines) {
    const TriangleMesh& mesh = test_meshes::mesh_named("bumpy_sphere").mesh;
    const LineExtractor extractor(mesh, precompute(mesh));
    const View view = View::perspective({3, 2, 4});
    LineStyle style = single_strokes();
    const LineSet single = helpers::extract(extractor, view, style);
    style.single_strokes = false;
    const LineSet all = helpers::extract(extractor, view, style);
    ASSERT_FALSE(single.lines.empty());
    EXPECT_LT(single.points.size(), all.points.size());
    for (const LinePoint& p : single.points)
        EXPECT_TRUE(std::any_of(all.points.begin(), all.points.end(),
                                [&](const LinePoint& q) { return p.position == q.position; }));
}

const Eigen::Vector3d kOblique = Eigen::Vector3d(1, 2, 3).normalized();

/// On a sphere ΔI = Δn·d vanishes where n·d does, whatever the eye; contours stay the eye's.
TEST(Light, DirectionalLightDrawsItsOwnTerminator) {
    const auto sphere = test_meshes::sphere(5);
    const LineExtractor extractor(sphere.mesh,
                                  helpers::true_field(sphere, measure_scale(sphere.mesh)));
    View view = View::perspective(4 * kOblique);
    const LineSet contours = extract(extractor, view, helpers::all_contours());
    ASSERT_FALSE(contours.lines.empty());
    view.light = Eigen::Vector3d(0.3, -5, 1);
    const LineSet lines = extract(extractor, view, helpers::all_laplacian_lines());
    ASSERT_EQ(lines.lines.size(), 1u);
    EXPECT_TRUE(lines.lines[0].closed);
    for (const LinePoint& p : lines.points)
        EXPECT_NEAR(p.position.cast<double>().dot(view.light->normalized()), 0, 2e-3);
    EXPECT_TRUE(helpers::same_lines(extract(extractor, view, helpers::all_contours()), contours));
}

}  // namespace
