// SPDX-License-Identifier: GPL-3.0-or-later
#include "strokes/strokes.h"

#include <gtest/gtest.h>

#include "strokes/drawn_lines.h"

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

/// What goes beyond the end of the line that it doubles meets it.
TEST(Overlaps, LeaveNoGaps) {
    const auto rest = withoutDoubles({line(LineClass::Contour, {{0, 0}, {20, 0}}),
                                      line(LineClass::Contour, {{15, 0.05}, {30, 0.05}})},
                                     reach);
    ASSERT_EQ(rest.size(), 2u);
    EXPECT_GE(rest[1].points.front().position.x(), 20 - reach);
    EXPECT_LE(rest[1].points.front().position.x(), 20);
}

TEST(Overlaps, OfOneClassTheLongestStays) {
    const auto rest = withoutDoubles({line(LineClass::Contour, {{3, 0.05}, {9, 0.05}}),
                                      line(LineClass::Contour, {{0, 0}, {20, 0}})},
                                     reach);
    ASSERT_EQ(rest.size(), 1u);
    EXPECT_EQ(rest[0].points.back().position, Eigen::Vector2d(20, 0));
}

/// The short line between them has doubled the outline.
TEST(Overlaps, EndsMeetTheLinesThatTheyAreBeside) {
    const auto rest = withoutDoubles({line(LineClass::Outline, {{0, 0}, {20, 0}}),
                                      line(LineClass::Edge, {{5, 0.8 * reach}, {5, 10}}),
                                      line(LineClass::Edge, {{8, 3 * reach}, {8, 10}})},
                                     reach);
    ASSERT_EQ(rest.size(), 3u);
    EXPECT_NEAR(rest[1].points.front().position.y(), 0, 1e-9);
    EXPECT_NEAR(rest[2].points.front().position.y(), 3 * reach, 1e-9);
}

bool isAt(const Eigen::Vector2d& place, const DrawnLine& line) {
    DrawnLines lines(reach);
    lines.add(positionsOf(line));
    return lines.nearestOn(place, 1, same_reach * reach).has_value();
}

/// Moving each to the other's place would leave the gap.
TEST(Overlaps, EndsBesideEachOtherAreJoined) {
    const auto rest = withoutDoubles({line(LineClass::Edge, {{0, 0}, {10, 0}}),
                                      line(LineClass::Edge, {{10.1, 0.1}, {10.1, 12}})},
                                     reach);
    ASSERT_EQ(rest.size(), 2u);
    EXPECT_TRUE(isAt(rest[1].points.back().position, rest[0]) ||
                isAt(rest[1].points.front().position, rest[0]));
    EXPECT_TRUE(isAt({0, 0}, rest[1]) &&
                isAt({10, 0}, rest[1]));  // what meets it there does so yet
}

/// A step between two edges that end on different lines has no white beside it, but joins them.
/// Also an edge that has passed the line it met, and two that have passed each other, as where a
/// hub's rims are cut into triangles at different places.
TEST(Overlaps, EdgesDoNotGoPastTheirCorners) {
    std::vector<DrawnLine> lines = {line(LineClass::Contour, {{0, 0}, {0, 10.05}}),
                                    line(LineClass::Contour, {{-9, 10}, {0, 10}})};
    joinLooseEnds(lines, {}, reach);
    EXPECT_EQ(lines[0].points.back().position, Eigen::Vector2d(0, 10));
    EXPECT_EQ(lines[0].points.size(), 2u) << "without a way back";
    lines = {line(LineClass::Edge, {{-9, 0}, {0.04, 0.1}}),
             line(LineClass::Edge, {{0, 0}, {9, -0.1}})};
    joinLooseEnds(lines, {}, reach);
    EXPECT_EQ(lines[0].points.back().position, lines[1].points.front().position);
}

TEST(Overlaps, ShortLinesThatJoinAnEndToAnotherLineStay) {
    std::vector<DrawnLine> lines = {line(LineClass::Contour, {{0, 0}, {20, 0}}),
                                    line(LineClass::Edge, {{5, 10}, {5, 1.5 * reach}})};
    const DrawnLine step =
        line(LineClass::Edge, {{5, 1.5 * reach}, {5 + reach, 0.9 * reach}, {5 + 2 * reach, 0}});
    const DrawnLine aside =
        line(LineClass::Edge, {{9, 0.1}, {9.1, 1.3 * reach}, {9.4, 1.3 * reach}, {9.5, 0.1}});
    joinLooseEnds(lines, {aside, step}, reach);
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_EQ(positionsOf(lines[2]), positionsOf(step));
}

TEST(Overlaps, AreFoundLeftOfAndAboveZero) {
    DrawnLines there(reach);
    there.add({{-7, -3}, {-5, -3}});
    EXPECT_TRUE(there.runAlong({-6, -3.1}, {1, 0}, 0.11));
    EXPECT_TRUE(there.runAlong({-6, -2.9}, {-1, 0}, 0.11));
    EXPECT_FALSE(there.runAlong({-6, -2.9}, {-1, 0}, 0.09));
    EXPECT_FALSE(there.runAlong({-6, -3}, {0, 1}, reach));
    EXPECT_FALSE(there.runAlong({-4, -3}, {1, 0}, reach));
}

TEST(Overlaps, ShortPartsThatLieOnAnotherLineAreLeftOut) {
    const auto rest =
        withoutDoubles({line(LineClass::Contour, {{0, 0}, {20, 0}}),
                        line(LineClass::Inner, {{5, 3}, {5.5, 0.01}, {6, 0.01}, {6.5, 3}})},
                       reach);
    ASSERT_EQ(rest.size(), 3u);
    EXPECT_NEAR(rest[1].points.back().position.x(), 5.5, 0.05);
    EXPECT_NEAR(rest[2].points.front().position.x(), 6, 0.05);
}

/// Short bumps leave no white beside a line; real lines do.
TEST(Overlaps, ShortLinesBesideAnotherAreLeftOut) {
    const DrawnLine outline = line(LineClass::Contour, {{0, 0}, {20, 0}});
    const auto rest_of = [&](const DrawnLine& bump) {
        return withoutDoubles({outline, bump}, reach).size() - 1;
    };
    const double near = 1.3 * reach, far = 2 * reach;
    const auto bump = [](double x, double height) {
        return line(LineClass::Contour, {{5, 0.1}, {5.1, height}, {x, height}, {x + 0.1, 0.1}});
    };
    EXPECT_EQ(rest_of(bump(5.6, near)), 0u);
    EXPECT_EQ(rest_of(bump(5.6, far)), 1u);
    EXPECT_EQ(rest_of(bump(8, near)), 1u);                                             // long
    EXPECT_EQ(rest_of(line(LineClass::Contour, {{20.12, 0.05}, {20.25, 0.05}})), 1u);  // goes on
    // from where another line ends
    EXPECT_EQ(rest_of(line(LineClass::Contour, {{5, near}, {5.5, 0.1}})), 1u);
}

TEST(Overlaps, LinesAtOnePlaceAreOne) {
    const auto rest = withoutDoubles({line(LineClass::Contour, {{0, 0}, {0.13, 0}}),
                                      line(LineClass::Edge, {{0.13, 0.01}, {0, 0.01}})},
                                     reach);
    EXPECT_EQ(rest.size(), 1u);
}

TEST(Overlaps, LinesEndWhereTheyMeetOthers) {
    // Each ends beside the other.
    const auto rest = withoutDoubles({line(LineClass::Contour, {{0, 0}, {10, 0}}),
                                      line(LineClass::Contour, {{9.6, 0.01}, {15, 0.01}})},
                                     reach);
    ASSERT_EQ(rest.size(), 2u);
    const double end = rest[0].points.back().position.x();
    const double begin = rest[1].points.front().position.x();
    EXPECT_NEAR(end, begin, 0.1);
}

TEST(Overlaps, LinesHaveNoJogs) {
    const auto rest = withoutDoubles(
        {line(LineClass::Contour, {{0, 0}, {10, 0}, {9.8, 0.01}, {10.5, 0.02}, {20, 0}})}, reach);
    ASSERT_EQ(rest.size(), 1u);
    const auto& points = rest[0].points;
    EXPECT_EQ(points.front().position, Eigen::Vector2d(0, 0));
    EXPECT_EQ(points.back().position, Eigen::Vector2d(20, 0));
    for (std::size_t i = 1; i < points.size(); ++i)
        EXPECT_GT(points[i].position.x(), points[i - 1].position.x()) << i;
    // A spike is no jog.
    const DrawnLine spike = line(LineClass::Contour, {{0, 0}, {10, 0}, {2, 3}});
    EXPECT_EQ(withoutDoubles({spike}, reach)[0].points.size(), 3u);
}

}  // namespace
