// SPDX-License-Identifier: GPL-3.0-or-later
// The array in which lines are passed to OpenGL, without points that make no visible difference.
#include "line_stream.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "synthetic_lines.h"

namespace {

using laplacian_lines::LinePoint;
using laplacian_lines::LineSet;
using line_renderer::LinePlacement;
using line_renderer::StreamPoint;
using line_renderer::StreamSettings;

/// All parts in sequence; checks that nothing is written between them.
std::vector<StreamPoint> written_stream(const laplacian_lines::LineSet& lines,
                                        const StreamSettings& settings) {
    const StreamPoint untouched = {{-7, -7, -7}, -7, -7, -7, -7};
    std::vector<StreamPoint> stream(line_renderer::stream_length(lines) + 1, untouched), result;
    std::vector<line_renderer::StreamPart> parts;
    line_renderer::write_stream(lines, settings, stream.data(), parts);
    std::size_t next = 0;
    const auto skip_to = [&](std::size_t end) {
        for (; next < end; ++next)
            EXPECT_EQ(stream[next].radius, untouched.radius) << "written between parts: " << next;
    };
    for (const line_renderer::StreamPart& part : parts) {
        skip_to(part.first);
        next += part.length;
        EXPECT_LT(next, stream.size()) << "written beyond its length";
        result.insert(result.end(), stream.begin() + std::ptrdiff_t(part.first),
                      stream.begin() + std::ptrdiff_t(next));
    }
    skip_to(stream.size());
    return result;
}

const Eigen::Vector2f kHalfViewport(500, 350);  // pixels

StreamSettings settings() {
    StreamSettings result;
    result.radii.fill(3);
    result.half_viewport = kHalfViewport;
    result.tolerance.depth.fill(0.02f);
    result.is_measured = true;
    return result;
}

/// Of a single line, without marks.
std::vector<StreamPoint> points_of(const std::vector<LinePoint>& points,
                                   const StreamSettings& settings) {
    LineSet lines;
    add_line(lines, points);
    const std::vector<StreamPoint> stream = written_stream(lines, settings);
    return {stream.begin() + 1, stream.end() - 1};
}

TEST(LineSimplification, DrawsAStraightLineAsOneSegment) {
    std::vector<LinePoint> points;
    for (int i = 0; i <= 1000; ++i)
        points.push_back({{0.001f * float(i), 0.0005f * float(i), 0}, 0.001f * float(i), 0, 1});
    EXPECT_EQ(points_of(points, settings()).size(), 2u) << "tapered";
    points[500].position.y() += 0.6f / 350;
    EXPECT_EQ(points_of(points, settings()).size(), 5u) << "with a tooth of 0.6 pixels";
    points[500].position.y() -= 0.6f / 350;
    points[500].opacity = 0.5f;
    EXPECT_EQ(points_of(points, settings()).size(), 5u) << "with a faint place";
}

/// Of over 1500 pixels, the place 850 pixels on is half a pixel aside.
TEST(LineSimplification, IsAsExactFarFromTheStart) {
    std::vector<LinePoint> points;
    for (int i = 0; i <= 4000; ++i)
        points.push_back({{0.00075f * float(i) - 1.5f, 0.0003f * float(i), 0}, 1, 0, 1});
    EXPECT_EQ(points_of(points, settings()).size(), 2u);
    points[2200].position.y() += 0.5f / 350;
    EXPECT_EQ(points_of(points, settings()).size(), 5u);
}

TEST(LineSimplification, KeepsTheLengthAlongTheLine) {
    std::vector<LinePoint> points;
    for (int i = 0; i <= 400; ++i)  // teeth of a tenth of a pixel
        points.push_back({{0.1f * float(i) / 500, 0.1f * float(i % 2) / 350, 0}, 1, 0, 1});
    const std::vector<StreamPoint> drawn = points_of(points, settings());
    EXPECT_EQ(drawn.size(), 2u);
    EXPECT_NEAR(drawn.back().along, 400 * std::hypot(0.1f, 0.1f), 0.01);
}

/// Both ends are joined to drawn points.
TEST(LineSimplification, JoinsTheEndsOfClosedLines) {
    std::vector<LinePoint> circle;
    for (int i = 0; i <= 2000; ++i) {
        const float angle = float(i % 2000) * 2 * std::acos(-1.0f) / 2000;
        circle.push_back({{0.1f * std::cos(angle), 0.1f * std::sin(angle), 0}, 1, 0, 1});
    }
    LineSet lines;
    for (int i = 0; i < 2; ++i)
        add_line(lines, circle, laplacian_lines::LineKind::Laplacian, true);
    const std::vector<StreamPoint> stream = written_stream(lines, settings());
    const std::size_t length = stream.size() / 2;
    EXPECT_LT(length, 60u);
    for (std::size_t first : {std::size_t(0), length}) {
        const StreamPoint *begin = &stream[first], *end = begin + length - 1;
        EXPECT_EQ(begin->radius, line_renderer::kNeighbourOnly);
        EXPECT_EQ(end->radius, line_renderer::kNeighbourOnly);
        EXPECT_TRUE(std::equal(begin->position, begin->position + 3, (end - 2)->position));
        EXPECT_TRUE(std::equal(end->position, end->position + 3, (begin + 2)->position));
        EXPECT_TRUE(
            std::equal((begin + 1)->position, (begin + 1)->position + 3, (end - 1)->position));
    }
}

/// Focal length 2, near plane 1, far plane 9, the eye at z = 4.
LinePlacement perspective() {
    LinePlacement placement;
    placement.to_eye.setIdentity();
    placement.to_eye(2, 3) = -4;
    placement.projection << 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, -10.0 / 8, -18.0 / 8, 0, 0, -1, 0;
    return placement;
}

std::vector<StreamPoint> stream_of(const LineSet& lines, const LinePlacement& placement) {
    return written_stream(
        lines, stream_settings(line_renderer::LineAppearance(), placement, kHalfViewport));
}

TEST(LineSimplification, IsTheSameInAllTilesOfAPicture) {
    std::vector<Eigen::Vector3f> wave;
    for (int i = 0; i < 5000; ++i) {
        const float x = 0.0002f * float(i);
        wave.push_back({x, 0.1f * std::sin(40 * x), 0.3f * std::cos(9 * x)});
    }
    const LineSet lines = one_line(wave);
    LinePlacement tile = perspective();
    tile.picture_to_clip = tile.projection * tile.to_eye;
    const std::vector<StreamPoint> middle = stream_of(lines, tile);
    EXPECT_LT(middle.size(), wave.size() / 10);
    for (double offset : {-3.0, -1.0, 1.0, 3.0}) {
        tile.projection(0, 2) = tile.projection(1, 2) = offset;
        const std::vector<StreamPoint> stream = stream_of(lines, tile);
        ASSERT_EQ(stream.size(), middle.size());
        EXPECT_EQ(std::memcmp(stream.data(), middle.data(), stream.size() * sizeof(StreamPoint)),
                  0);
    }
}

}  // namespace
