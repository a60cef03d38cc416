// SPDX-License-Identifier: GPL-3.0-or-later
// Against a search through all pieces of all lines.
#include "fixed/near_lines.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

namespace {

using namespace laplacian_lines;
using Eigen::Vector3f;

void add_line(LineSet& set, const std::vector<Vector3f>& positions) {
    Polyline line;
    line.first = std::uint32_t(set.points.size());
    line.count = std::uint32_t(positions.size());
    for (const Vector3f& p : positions)
        set.points.push_back({p, 1, 0, 1});
    set.lines.push_back(line);
}

LineSet random_lines(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> number(-1, 1);
    LineSet set;
    for (int i = 0; i < 20; ++i) {
        std::vector<Vector3f> positions = {{number(random), number(random), number(random)}};
        for (int k = 0; k < 10; ++k)
            positions.push_back(positions.back() +
                                0.3f * Vector3f(number(random), number(random), number(random)));
        add_line(set, positions);
    }
    return set;
}

bool any_along_plainly(const LineSet& lines, float distance, const Vector3f& p,
                       const Vector3f& direction) {
    for (const Polyline& line : lines.lines)
        for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i) {
            const Vector3f a = lines.points[i - 1].position, span = lines.points[i].position - a;
            const float t = std::min(std::max((p - a).dot(span) / span.squaredNorm(), 0.f), 1.f);
            const float cosine = std::abs(span.dot(direction)) / (span.norm() * direction.norm());
            if ((a + t * span - p).norm() <= distance &&
                (direction.isZero(0) || cosine >= std::sqrt(0.5f)))
                return true;
        }
    return false;
}

TEST(NearLines, AreThoseThatAPlainSearchFinds) {
    const LineSet lines = random_lines(1);
    std::mt19937 random(2);
    std::uniform_real_distribution<float> number(-1, 1);
    for (const float distance : {0.02f, 0.1f, 0.5f}) {
        const NearLines near(lines, distance);
        std::size_t found = 0;
        for (int i = 0; i < 2000; ++i) {
            // Half of them near a line.
            Vector3f p(number(random), number(random), number(random));
            if (i % 2)
                p = lines.points[std::size_t(i) % lines.points.size()].position + distance * p;
            const Vector3f direction(number(random), number(random), number(random));
            const bool is_near = near.any_along(p, direction);
            EXPECT_EQ(is_near, any_along_plainly(lines, distance, p, direction));
            EXPECT_EQ(near.any_along(p, Vector3f::Zero()),
                      any_along_plainly(lines, distance, p, Vector3f::Zero()));
            found += is_near;
        }
        EXPECT_GT(found, 100u);
        EXPECT_LT(found, 1900u);
    }
}

TEST(NearLines, MarkPointsThatGoAlongOtherLines) {
    LineSet creases, ridges;
    add_line(creases, {{0, 0, 0}, {1, 0, 0}});
    add_line(ridges, {{0.2f, 0.005f, 0}, {0.4f, 0.005f, 0}, {0.6f, 0.005f, 0}});  // doubles it
    add_line(ridges, {{0.5f, -0.02f, 0}, {0.5f, 0, 0}, {0.5f, 0.02f, 0}});        // crosses it
    add_line(ridges, {{0.2f, 0.02f, 0}, {0.4f, 0.02f, 0}, {1.6f, 0.02f, 0}});     // is beside it
    const std::vector<std::uint8_t> along = points_along(ridges, NearLines(creases, 0.01f));
    EXPECT_EQ(along, (std::vector<std::uint8_t>{1, 1, 1, 0, 0, 0, 0, 0, 0}));
}

TEST(NearLines, AreNoneWithoutLinesOrDistance) {
    LineSet lines;
    add_line(lines, {{0, 0, 0}, {1, 0, 0}});
    EXPECT_FALSE(NearLines(LineSet(), 1).any_along({0, 0, 0}, {1, 0, 0}));
    EXPECT_FALSE(NearLines(lines, 0).any_along({0, 0, 0}, {1, 0, 0}));
    EXPECT_TRUE(NearLines(lines, 1e-3f).any_along({0.5f, 0, 0}, {1, 0, 0}));
}

}  // namespace
