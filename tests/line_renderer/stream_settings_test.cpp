// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_stream.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "made_up_lines.h"

namespace {

using laplacian_lines::LineSet;
using line_renderer::LineAppearance;
using line_renderer::LinePlacement;
using line_renderer::StreamPoint;
using line_renderer::StreamSettings;

const Eigen::Vector2f half_viewport(500, 350);

/// Focal length 2, near plane 1, far plane 9, the eye at z = 4.
LinePlacement perspective() {
    LinePlacement placement;
    placement.to_eye.setIdentity();
    placement.to_eye(2, 3) = -4;
    placement.projection << 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, -10.0 / 8, -18.0 / 8, 0, 0, -1, 0;
    return placement;
}

double depthOf(const LinePlacement& placement, double z) {
    const Eigen::Vector4d clip =
        placement.projection * placement.to_eye * Eigen::Vector4d(0, 0, z, 1);
    return clip.z() / clip.w();
}

/// A quarter of the kind's clearance.
TEST(StreamSettings, AllowsDepthsAShareOfTheClearance) {
    const LinePlacement placement = perspective();
    const StreamSettings settings = streamSettings(LineAppearance(), placement, half_viewport);
    const double z = 1, w = 4 - z;
    const double clearance = line_renderer::lineClearance(0, placement);
    EXPECT_NEAR(settings.tolerance.depth[0] / (w * w),
                (depthOf(placement, z) - depthOf(placement, z + clearance)) / 4, 1e-5);
}

TEST(StreamSettings, MeasuresDashesOnly) {
    LineAppearance appearance;
    EXPECT_FALSE(streamSettings(appearance, perspective(), half_viewport).is_measured);
    appearance.hidden = line_renderer::HiddenLines::Dashed;
    EXPECT_TRUE(streamSettings(appearance, perspective(), half_viewport).is_measured);
}

std::vector<StreamPoint> streamOf(const LineSet& lines, const LinePlacement& placement) {
    return writtenStream(lines, streamSettings(LineAppearance(), placement, half_viewport));
}

TEST(StreamSettings, IsTheSameInAllTilesOfAPicture) {
    std::vector<Eigen::Vector3f> wave;
    for (int i = 0; i < 5000; ++i) {
        const float x = 0.0002f * float(i);
        wave.push_back({x, 0.1f * std::sin(40 * x), 0.3f * std::cos(9 * x)});
    }
    const LineSet lines = oneLine(wave);
    LinePlacement tile = perspective();
    tile.picture_to_clip = tile.projection * tile.to_eye;
    const std::vector<StreamPoint> middle = streamOf(lines, tile);
    EXPECT_LT(middle.size(), wave.size() / 10);
    for (double offset : {-3.0, -1.0, 1.0, 3.0}) {
        tile.projection(0, 2) = tile.projection(1, 2) = offset;
        const std::vector<StreamPoint> stream = streamOf(lines, tile);
        ASSERT_EQ(stream.size(), middle.size());
        EXPECT_EQ(std::memcmp(stream.data(), middle.data(), stream.size() * sizeof(StreamPoint)),
                  0);
    }
}

}  // namespace
