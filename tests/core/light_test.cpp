// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of a directional light that is not at the eye.
#include <gtest/gtest.h>

#include <cmath>

#include "helpers.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace laplacian_lines;
using helpers::extract;
using helpers::total_length;

const Eigen::Vector3d kDirection = Eigen::Vector3d(1, 2, 3).normalized();

/// On a sphere ΔI = Δn·d vanishes where n·d does, whatever the eye; contours stay the eye's.
TEST(Light, DirectionalLightDrawsItsOwnTerminator) {
    const auto sphere = test_meshes::sphere(5);
    PrecomputeOptions options;  // the sphere's normals exact, so that only the lines are looked at
    options.normal_weighting = NormalWeighting::Max;
    options.normal_smoothing = NormalSmoothing::None;
    options.kernel_size = 0.15;
    const LineExtractor extractor(sphere.mesh, precompute(sphere.mesh, options));
    View view = View::perspective(4 * kDirection);
    const LineSet contours = extract(extractor, view, helpers::all_contours());
    view.light = Eigen::Vector3d(0.3, -5, 1);
    const LineSet lines = extract(extractor, view, helpers::all_laplacian_lines());
    ASSERT_EQ(lines.lines.size(), 1u);
    EXPECT_TRUE(lines.lines[0].closed);
    for (const LinePoint& p : lines.points)
        EXPECT_NEAR(p.position.cast<double>().dot(view.light->normalized()), 0, 2e-3);
    const LineSet lit_contours = extract(extractor, view, helpers::all_contours());
    ASSERT_EQ(lit_contours.points.size(), contours.points.size());
    for (std::size_t i = 0; i < contours.points.size(); ++i)
        EXPECT_EQ(lit_contours.points[i].position, contours.points[i].position);
}

TEST(Light, AlongTheViewDirectionChangesNothingInOrthographicViews) {
    const auto torus = test_meshes::mesh_named("torus");
    const LineExtractor extractor(torus.mesh, precompute(torus.mesh));
    View view = View::orthographic(kDirection);
    LineStyle style;
    style.contour_clearance = 0;
    const LineSet at_the_eye = extract(extractor, view, style);
    view.light = 7 * kDirection;
    EXPECT_TRUE(helpers::same_lines(at_the_eye, extract(extractor, view, style)));
    view.light = Eigen::Vector3d(-kDirection.y(), kDirection.x(), 0);
    EXPECT_FALSE(helpers::same_lines(at_the_eye, extract(extractor, view, style)));
}

/// Reversed: a light from behind needs no elevation of its own.
TEST(Light, OppositeDirectionsDrawTheSameLines) {
    const auto bumps = test_meshes::mesh_named("bumpy_sphere");
    const LineExtractor extractor(bumps.mesh, precompute(bumps.mesh));
    View view = View::perspective(4 * kDirection);
    for (bool single_strokes : {true, false}) {
        LineStyle style = helpers::all_laplacian_lines();
        style.single_strokes = single_strokes;
        view.light = Eigen::Vector3d(0.3, -0.5, 1);
        const LineSet lines = extract(extractor, view, style);
        EXPECT_FALSE(lines.lines.empty());
        view.light = -*view.light;
        const LineSet opposite = extract(extractor, view, style);
        EXPECT_EQ(opposite.lines.size(), lines.lines.size());
        EXPECT_EQ(opposite.points.size(), lines.points.size());
        EXPECT_NEAR(total_length(opposite), total_length(lines), 1e-4f * total_length(lines));
        view.light->z() += 0.3;  // the measure does tell other lights apart
        const float other = total_length(extract(extractor, view, style));
        EXPECT_GT(std::abs(other - total_length(lines)), 1e-2f * total_length(lines));
    }
}

}  // namespace
