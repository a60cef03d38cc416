// SPDX-License-Identifier: GPL-3.0-or-later
// Single strokes: of the zero crossings, only those where the surface is concave towards the light.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "made_up_line.h"

namespace {

using namespace laplacian_lines;
using helpers::MadeUp;

LineStyle single_strokes() {
    LineStyle style = helpers::all_laplacian_lines();
    style.single_strokes = true;
    style.fading = style.end_length = 0;
    return style;
}

const Eigen::Vector3d kRight(0.3, 0, 1), kLeft(-0.3, 0, 1), kAbove(0, 0, 1);

bool is_drawn(double gradient, const View& view) {
    MadeUp made_up;
    made_up.gradient = gradient;
    return !helpers::extract(made_up.extractor(), view, single_strokes()).lines.empty();
}

/// l·S l = 2 gradient l_x l_z.
TEST(SingleStrokes, AreWhereTheSurfaceIsConcaveTowardsTheEye) {
    EXPECT_TRUE(is_drawn(-1, View::orthographic(kRight)));
    EXPECT_FALSE(is_drawn(-1, View::orthographic(kLeft)));
    EXPECT_FALSE(is_drawn(1, View::orthographic(kRight)));
    EXPECT_TRUE(is_drawn(1, View::orthographic(kLeft)));
}

TEST(SingleStrokes, FollowALightElsewhere) {
    View view = View::orthographic(kAbove);
    view.light = kRight;
    EXPECT_TRUE(is_drawn(-1, view));
    view.light = kLeft;
    EXPECT_FALSE(is_drawn(-1, view));
}

/// The measure −l·S l/(‖w‖‖S l‖) goes from nothing at −fading/4 to full at fading/2.
TEST(SingleStrokes, FadeInFromConvexToConcave) {
    const Eigen::Vector3d l = Eigen::Vector3d(0, 0.6, 0.8);
    for (const double trace : {0.08, 0.03, -0.05, -0.2, -0.4}) {
        MadeUp made_up;
        made_up.trace = trace;
        const double measure = -trace * l.y() / std::hypot(l.z(), trace * l.y());
        const double expected = std::clamp((measure + 0.1) / 0.3, 0., 1.);
        for (const bool at_eye : {true, false}) {
            View view = View::orthographic(at_eye ? l : kAbove);
            if (!at_eye) view.light = l;
            LineStyle style = single_strokes();
            style.fading = 0.4;
            const LineSet set = helpers::extract(made_up.extractor(), view, style);
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

}  // namespace
