// SPDX-License-Identifier: GPL-3.0-or-later
#include "overlaps.h"

#include <gtest/gtest.h>

using namespace line_drawing;

namespace {

constexpr double reach = 0.2;

DrawnLine line(LineClass line_class, std::initializer_list<Eigen::Vector2d> positions) {
    DrawnLine result{line_class, false, {}};
    for (const Eigen::Vector2d& p : positions)
        result.points.push_back({p, 1});
    return result;
}

TEST(Overlaps, ALineAlongAnOutlineIsLeftOutThereOnly) {
    const auto rest = withoutDoubles({line(LineClass::Inner, {{0, 5}, {0, 0.1}, {20, 0.1}}),
                                      line(LineClass::Outline, {{-10, 0}, {30, 0}})},
                                     reach);
    ASSERT_EQ(rest.size(), 2u);
    EXPECT_EQ(rest[0].line_class, LineClass::Outline);
    EXPECT_EQ(rest[0].points.size(), 2u);
    EXPECT_EQ(rest[1].points.front().position, Eigen::Vector2d(0, 5));
    EXPECT_LT(rest[1].points.back().position.y(), 0.4);
    EXPECT_LE(rest[1].points.back().position.x(), 2 * reach);
}

TEST(Overlaps, LinesThatCrossOrEndAtOthersStayWhole) {
    const std::vector<DrawnLine> lines = {
        line(LineClass::Outline, {{0, 0}, {20, 0}}), line(LineClass::Inner, {{5, -5}, {5, 5}}),
        line(LineClass::Inner, {{10, 6}, {11, 0}}), line(LineClass::Fine, {{0, 1}, {20, 1}})};
    const auto rest = withoutDoubles(lines, reach);
    ASSERT_EQ(rest.size(), lines.size());
    for (const DrawnLine& l : rest)
        EXPECT_EQ(l.points.size(), 2u);
}

/// What goes on beyond the end of the line that it doubles meets it.
TEST(Overlaps, LeaveNoGaps) {
    const auto rest = withoutDoubles({line(LineClass::Outline, {{0, 0}, {20, 0}}),
                                      line(LineClass::Outline, {{15, 0.05}, {30, 0.05}})},
                                     reach);
    ASSERT_EQ(rest.size(), 2u);
    EXPECT_GE(rest[1].points.front().position.x(), 20 - reach);
    EXPECT_LE(rest[1].points.front().position.x(), 20);
}

TEST(Overlaps, OfOneClassTheLongestStays) {
    const auto rest = withoutDoubles({line(LineClass::Outline, {{3, 0.05}, {9, 0.05}}),
                                      line(LineClass::Outline, {{0, 0}, {20, 0}})},
                                     reach);
    ASSERT_EQ(rest.size(), 1u);
    EXPECT_EQ(rest[0].points.back().position, Eigen::Vector2d(20, 0));
}

TEST(Overlaps, AreFoundLeftOfAndAboveZero) {
    DrawnLines there(reach);
    there.add({{-7, -3}, {-5, -3}});
    EXPECT_TRUE(there.runsAlong({-6, -3.1}, {1, 0}));
    EXPECT_TRUE(there.runsAlong({-6, -2.9}, {-1, 0}));
    EXPECT_FALSE(there.runsAlong({-6, -2.7}, {1, 0}));
    EXPECT_FALSE(there.runsAlong({-6, -3}, {0, 1}));
    EXPECT_FALSE(there.runsAlong({-4, -3}, {1, 0}));
}

}  // namespace
