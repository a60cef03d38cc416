// SPDX-License-Identifier: GPL-3.0-or-later
// Invisible points are dropped: a plain search finds a place of what is drawn that looks like each
// dropped point.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "line_stream.h"
#include "made_up_lines.h"

namespace {

using Eigen::Vector3f;
using laplacian_lines::LinePoint;
using laplacian_lines::LineSet;
using laplacian_lines::Polyline;
using line_renderer::StreamPoint;
using line_renderer::StreamSettings;

constexpr float full_radius = 3, depth_tolerance = 0.02f;

/// 1000 x 700 pixels; in perspective the eye is at z = 3, the near plane at z = 2.
StreamSettings settings(bool is_perspective) {
    StreamSettings result;
    result.radii.full.fill(full_radius);
    result.screen.half_viewport = {500, 350};
    result.tolerance.depth.fill(depth_tolerance);
    result.is_measured = true;
    if (is_perspective)
        result.screen.to_clip << 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, -1.25f, 1.5f, 0, 0, -1, 3;
    return result;
}

/// Pixels, depth, radius, opacity.
using Seen = Eigen::Matrix<double, 5, 1>;

struct Sight {
    Seen seen;
    double w = 1;
    bool is_before_eye = true;
};

Sight see(const Vector3f& position, float radius, float opacity, const StreamSettings& settings) {
    const Eigen::Vector4d clip =
        settings.screen.to_clip.cast<double>() * position.cast<double>().homogeneous();
    Sight sight;
    sight.w = clip.w();
    sight.is_before_eye = clip.w() > 0 && clip.z() > -clip.w();
    const Eigen::Vector3d place = clip.head<3>() / clip.w();
    sight.seen << place.x() * 500, place.y() * 350, place.z(), double(radius), double(opacity);
    return sight;
}

Sight see(const StreamPoint& point, const StreamSettings& settings) {
    return see({point.position[0], point.position[1], point.position[2]}, point.radius,
               point.opacity, settings);
}

Sight see(const LinePoint& point, const StreamSettings& settings) {
    const float radius = full_radius * (0.35f + 0.65f * point.weight);
    return see(point.position, radius, point.opacity, settings);
}

bool looksAs(const Seen& drawn, const Sight& point, const StreamSettings& settings) {
    constexpr double rounding = 2e-3;
    const Seen difference = (drawn - point.seen).cwiseAbs();
    return (drawn - point.seen).head<2>().norm() <= settings.tolerance.distance + rounding &&
           difference[2] <= depth_tolerance / (point.w * point.w) + 1e-5 &&
           difference[3] <= settings.tolerance.radius + rounding &&
           difference[4] <= settings.tolerance.opacity + rounding;
}

/// The first part of a segment from `part` on; above 1 if there is none.
double partThatLooksAs(const Sight& point, const Seen& a, const Seen& b, double part,
                       const StreamSettings& settings) {
    const double step = 0.02 / std::max(1.0, (b - a).head<2>().norm());
    while (part <= 1 && !looksAs(a + part * (b - a), point, settings))
        part += step;
    if (part > 1 && looksAs(b, point, settings)) part = 1;
    return part;
}

bool isAt(const StreamPoint& drawn, const LinePoint& point) {
    return Vector3f(drawn.position[0], drawn.position[1], drawn.position[2]) == point.position &&
           drawn.opacity == point.opacity;
}

/// StraightPiece's promise for one line; `drawn` has no marks.
void expectPromise(const LinePoint* points, std::size_t count,
                   const std::vector<StreamPoint>& drawn, const StreamSettings& settings) {
    ASSERT_GE(drawn.size(), 2u);
    ASSERT_TRUE(isAt(drawn.front(), points[0]));
    ASSERT_TRUE(isAt(drawn.back(), points[count - 1]));
    std::size_t end = 1;
    double part = 0;
    for (std::size_t i = 1; i + 1 < count; ++i) {
        if (end + 1 < drawn.size() && isAt(drawn[end], points[i])) {
            ++end;
            part = 0;
            continue;
        }
        const Sight point = see(points[i], settings);
        const Sight a = see(drawn[end - 1], settings), b = see(drawn[end], settings);
        ASSERT_TRUE(point.is_before_eye && a.is_before_eye && b.is_before_eye) << i;
        part = partThatLooksAs(point, a.seen, b.seen, part, settings);
        ASSERT_LE(part, 1) << "point " << i << " between those drawn as " << end - 1 << ", " << end;
    }
    EXPECT_EQ(end + 1, drawn.size()) << "points that the line does not have, or in another order";
}

struct Chain {
    float step, roughness;         ///< pixels; change of direction at each point, radians
    float value_step, depth_step;  ///< of weight and opacity; of z
};

std::vector<LinePoint> randomChain(const Chain& chain, int count, std::mt19937& random) {
    std::normal_distribution<float> normal;
    std::vector<LinePoint> points;
    float direction = 3 * normal(random), weight = 0.5f, opacity = 0.5f;
    Vector3f place(0, 0, 0);
    for (int i = 0; i < count; ++i) {
        points.push_back({place, weight, 0, opacity});
        direction += chain.roughness * normal(random);
        const float step = chain.step * std::abs(normal(random));
        place += Vector3f(step * std::cos(direction) / 500, step * std::sin(direction) / 350,
                          chain.depth_step * normal(random));
        weight = std::clamp(weight + chain.value_step * normal(random), 0.0f, 1.0f);
        opacity = std::clamp(opacity + chain.value_step * normal(random), 0.0f, 1.0f);
    }
    return points;
}

void append(LineSet& lines, const std::vector<LinePoint>& points, bool closed = false) {
    Polyline line;
    line.first = std::uint32_t(lines.points.size());
    line.count = std::uint32_t(points.size());
    line.closed = closed;
    lines.lines.push_back(line);
    lines.points.insert(lines.points.end(), points.begin(), points.end());
}

/// Of a single line, without marks.
std::vector<StreamPoint> pointsOf(const std::vector<LinePoint>& points,
                                  const StreamSettings& settings) {
    LineSet lines;
    append(lines, points);
    const std::vector<StreamPoint> stream = writtenStream(lines, settings);
    return {stream.begin() + 1, stream.end() - 1};
}

TEST(LineSimplification, LeavesOutOnlyWhatIsNotSeen) {
    std::mt19937 random(7);
    std::size_t all = 0, drawn = 0;
    for (const Chain& chain :
         {Chain{0.5f, 0.02f, 0, 0}, Chain{0.5f, 0.3f, 0.003f, 1e-5f}, Chain{0.1f, 2, 0.01f, 0},
          Chain{0.02f, 0.5f, 0.001f, 1e-4f}, Chain{4, 0.01f, 0.05f, 1e-3f}, Chain{0, 0, 0.005f, 0}})
        for (bool is_perspective : {false, true})
            for (int i = 0; i < 20; ++i) {
                const std::vector<LinePoint> points = randomChain(chain, 300, random);
                const std::vector<StreamPoint> kept = pointsOf(points, settings(is_perspective));
                expectPromise(points.data(), points.size(), kept, settings(is_perspective));
                if (HasFatalFailure()) return;
                all += points.size();
                drawn += kept.size();
            }
    EXPECT_LT(drawn, all / 2);
}

/// No point there is dropped.
TEST(LineSimplification, KeepsWhatIsBehindTheEye) {
    const StreamSettings sight = settings(true);
    std::vector<LinePoint> points;
    for (int i = 0; i < 200; ++i)
        points.push_back({{0.001f * float(i), 0, 4 * std::sin(0.05f * float(i))}, 1, 0, 1});
    const std::vector<StreamPoint> drawn = pointsOf(points, sight);
    expectPromise(points.data(), points.size(), drawn, sight);
    EXPECT_LT(drawn.size(), points.size());
}

TEST(LineSimplification, DrawsAStraightLineAsOneSegment) {
    std::vector<LinePoint> points;
    for (int i = 0; i <= 1000; ++i)
        points.push_back({{0.001f * float(i), 0.0005f * float(i), 0}, 0.001f * float(i), 0, 1});
    EXPECT_EQ(pointsOf(points, settings(false)).size(), 2u) << "tapered";
    points[500].position.y() += 0.6f / 350;
    EXPECT_EQ(pointsOf(points, settings(false)).size(), 5u) << "with a tooth of 0.6 pixels";
    points[500].position.y() -= 0.6f / 350;
    points[500].opacity = 0.5f;
    EXPECT_EQ(pointsOf(points, settings(false)).size(), 5u) << "with a faint place";
}

TEST(LineSimplification, ReachesThePlaceWhereALineTurnsBack) {
    const auto line = [](float back) {
        std::vector<LinePoint> points;
        for (float x : {0.0f, 4.0f, 9.0f, 9.0f - back / 2, 9.0f - back})
            points.push_back({{x / 500, 0, 0}, 1, 0, 1});
        return points;
    };
    EXPECT_EQ(pointsOf(line(6), settings(false)).size(), 3u);
    EXPECT_EQ(pointsOf(line(0.02f), settings(false)).size(), 2u);
}

TEST(LineSimplification, KeepsTheLengthAlongTheLine) {
    std::vector<LinePoint> points;
    for (int i = 0; i <= 400; ++i)  // teeth of a tenth of a pixel
        points.push_back({{0.1f * float(i) / 500, 0.1f * float(i % 2) / 350, 0}, 1, 0, 1});
    const std::vector<StreamPoint> drawn = pointsOf(points, settings(false));
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
    append(lines, circle, true);
    append(lines, circle, true);
    const std::vector<StreamPoint> stream = writtenStream(lines, settings(false));
    const std::size_t length = stream.size() / 2;
    EXPECT_LT(length, 60u);
    for (std::size_t first : {std::size_t(0), length}) {
        const StreamPoint *begin = &stream[first], *end = begin + length - 1;
        EXPECT_EQ(begin->radius, line_renderer::neighbour_only);
        EXPECT_EQ(end->radius, line_renderer::neighbour_only);
        EXPECT_TRUE(std::equal(begin->position, begin->position + 3, (end - 2)->position));
        EXPECT_TRUE(std::equal(end->position, end->position + 3, (begin + 2)->position));
        EXPECT_TRUE(
            std::equal((begin + 1)->position, (begin + 1)->position + 3, (end - 1)->position));
    }
}

/// Four times the points give as many segments.
TEST(LineSimplification, DependsOnTheViewAndNotOnTheMesh) {
    const auto wave = [](int count) {
        std::vector<LinePoint> points;
        for (int i = 0; i <= count; ++i) {
            const float x = float(i) / float(count);
            points.push_back({{x, 0.05f * std::sin(20 * x), 0}, 1, 0, 1});
        }
        return points;
    };
    const std::size_t coarse = pointsOf(wave(1000), settings(false)).size();
    EXPECT_LT(coarse, 100u);
    EXPECT_LE(pointsOf(wave(16000), settings(false)).size(), coarse * 11 / 10);
}

}  // namespace
