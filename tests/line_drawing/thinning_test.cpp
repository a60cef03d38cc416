// SPDX-License-Identifier: GPL-3.0-or-later
#include "strokes/strokes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sheet/sheet_layout.h"

using namespace line_drawing;
using Eigen::Vector2d;

namespace {

constexpr auto pens = pensOf(Weights::Illustrator);
constexpr double pen = 0.25;  // mm, of inner lines

/// Points .1 mm apart.
DrawnLine straight(const Vector2d& from, const Vector2d& to, double weight = 1,
                   LineClass line_class = LineClass::Inner) {
    DrawnLine line{line_class, false, {}};
    const int steps = int(std::ceil((to - from).norm() / 0.1));
    for (int i = 0; i <= steps; ++i)
        line.points.push_back({from + double(i) / steps * (to - from), weight,
                               laplacian_lines::kNoSightNode, line_class == LineClass::Edge});
    return line;
}

DrawnLine circle(double circumference) {
    DrawnLine line{LineClass::Inner, true, {}};
    const double radius = circumference / 6.2831853;
    for (int i = 0; i <= 100; ++i)
        line.points.push_back({radius * Vector2d(std::cos(0.062831853 * (i % 100)),
                                                 std::sin(0.062831853 * (i % 100))),
                               1, laplacian_lines::kNoSightNode, false});
    return line;
}

double lengthOfAll(const std::vector<DrawnLine>& lines) {
    double sum = 0;
    for (const DrawnLine& line : lines)
        sum += lengthOf(line.points);
    return sum;
}

TEST(Thinning, LeavesTheStrongerOfTwoLinesSideBySide) {
    const auto thinned =
        thinOut({straight({0, 0}, {20, 0}, 0.5), straight({0, 0.3}, {20, 0.3})}, pens);
    ASSERT_EQ(thinned.size(), 1u);
    EXPECT_EQ(thinned[0].points[0].position.y(), 0.3);
    for (const auto& [distance, count] : {std::pair(2.9 * pen, 1u), std::pair(3.1 * pen, 2u)})
        EXPECT_EQ(
            thinOut({straight({0, 0}, {20, 0}), straight({0, distance}, {20, distance})}, pens)
                .size(),
            count);
}

TEST(Thinning, LeavesLinesThatCrossOrMeet) {
    const std::vector<DrawnLine> lines = {straight({0, 0}, {20, 0}), straight({10, -8}, {10, 8}),
                                          straight({5, 0.04}, {5, 9})};
    EXPECT_NEAR(lengthOfAll(thinOut(lines, pens)), lengthOfAll(lines), 1e-9);
}

TEST(Thinning, TakesAwayOnlyThePartBesideAnotherLine) {
    const auto thinned =
        thinOut({straight({0, 0}, {20, 0}), straight({10, 0.2}, {30, 0.2}, 0.5)}, pens);
    ASSERT_EQ(thinned.size(), 2u);
    EXPECT_NEAR(lengthOf(thinned[1].points), 10, 0.7);
}

/// Of a fold mostly taken by others.
TEST(Thinning, LeavesNoIslands) {
    const auto left = [](double begin, double end) {
        return lengthOfAll(thinOut(
                   {straight({0, 0}, {20, 0}), straight({begin, 0.2}, {end, 0.2}, 0.5)}, pens)) -
               20;
    };
    EXPECT_NEAR(left(17, 24), 3.5, 0.5);  // half of it
    EXPECT_NEAR(left(12, 24), 0, 1e-9);
    EXPECT_NEAR(left(5, 27), 6.5, 0.5);  // long enough to stand alone
}

TEST(Thinning, LeavesWhiteBesideOutlinesAndEdgesWhichStay) {
    for (const LineClass c : {LineClass::Outline, LineClass::Contour, LineClass::Edge}) {
        const double touching = pens[std::size_t(c)] / 2 + pen / 2;
        const auto left = [&](double white, double rise) {
            const double y = touching + white * pen;
            return lengthOfAll(thinOut(
                       {straight({0, 0}, {20, 0}, 1, c), straight({0, y}, {20, y + rise})}, pens)) -
                   20;
        };
        EXPECT_EQ(left(1.4, 0), 0);
        EXPECT_NEAR(left(1.6, 0), 20, 1e-9);
        EXPECT_NEAR(left(0.6, pen), 20, 0.1);  // whole, or not at all
        EXPECT_EQ(left(0.6, 0.8 * pen), 0);
    }
}

TEST(Thinning, LeavesOutContoursThatAreSpecks) {
    for (const LineClass c : {LineClass::Outline, LineClass::Contour, LineClass::Edge}) {
        const DrawnLine speck = straight({0, 0}, {0.3, 0}, 1, c);
        EXPECT_EQ(thinOut({speck}, pens).size(), c == LineClass::Contour ? 0u : 1u);
        EXPECT_EQ(thinOut({straight({0, 0}, {6.1 * pen, 0}, 1, c)}, pens).size(), 1u);
        const DrawnLine met = straight({0.3, -5}, {0.3, 5});
        EXPECT_EQ(thinOut({speck, met}, pens).size(), 2u);
        EXPECT_EQ(thinOut({speck, straight({0.3, 0}, {0.8, 0})}, pens).size(),  // goes itself
                  c == LineClass::Contour ? 0u : 1u);
    }
}

TEST(Thinning, LeavesOutWhatIsTooShortToBeSeen) {
    EXPECT_TRUE(thinOut({straight({0, 0}, {5.9 * pen, 0})}, pens).empty());
    EXPECT_EQ(thinOut({straight({0, 0}, {6.1 * pen, 0})}, pens).size(), 1u);
    DrawnLine folded = straight({0, 0}, {3.5 * pen, 0});
    folded.points.push_back({{0, 0.5 * pen}, 1, laplacian_lines::kNoSightNode, false});
    EXPECT_TRUE(thinOut({folded}, pens).empty());
    EXPECT_TRUE(thinOut({circle(23 * pen)}, pens).empty());
    EXPECT_EQ(thinOut({circle(25 * pen)}, pens).size(), 1u);
}

std::size_t strokes(const std::vector<DrawnLine>& lines, bool with_contours = false) {
    return chain(lines, pens, with_contours).size();
}

TEST(Chaining, JoinsLinesOverGaps) {
    const DrawnLine first = straight({0, 0}, {10, 0});
    EXPECT_EQ(strokes({first, straight({11.5, 0}, {20, 0})}), 1u);
    EXPECT_EQ(strokes({first, straight({20, 0}, {11.5, 0})}), 1u);      // from the other end
    EXPECT_EQ(strokes({first, straight({12.5, 0}, {20, 0})}), 2u);      // too far
    EXPECT_EQ(strokes({first, straight({11.5, 0}, {13, 0})}), 2u);      // too short for the gap
    EXPECT_EQ(strokes({first, straight({11.5, 1.5}, {20, 1.5})}), 2u);  // aside
    EXPECT_EQ(strokes({first, straight({11, 0}, {11, 9})}), 2u);        // turns
    const DrawnLine across = straight({10.7, -3}, {10.7, 3}, 1, LineClass::Contour);
    EXPECT_EQ(strokes({first, straight({11.5, 0}, {20, 0}), across}), 3u);
}

/// From (x, 0), degrees to the left.
DrawnLine towards(double x, double angle, LineClass line_class = LineClass::Inner) {
    const double a = angle * 3.14159265 / 180;
    return straight({x, 0}, Vector2d(x, 0) + 9 * Vector2d(std::cos(a), std::sin(a)), 1, line_class);
}

TEST(Chaining, JoinsLinesOverGapsThatAnArcCloses) {
    EXPECT_EQ(strokes({towards(0, 180 - 25), towards(1.5, 25)}), 1u);
    EXPECT_EQ(strokes({towards(0, 180 - 35), towards(1.5, 35)}), 2u);
}

TEST(Chaining, LeadsEndsThatMeetToEachOtherWithoutAStep) {
    const double aside = 1.8 * pen;
    for (const LineClass c : {LineClass::Inner, LineClass::Contour}) {
        const auto chained = chain(
            {straight({0, 0}, {10, 0}, 1, c), straight({9.9, aside}, {20, aside})}, pens, true);
        ASSERT_EQ(chained.size(), 1u);
        const auto& points = chained[0].points;
        for (std::size_t i = 1; i < points.size(); ++i) {
            const Vector2d step = points[i].position - points[i - 1].position;
            EXPECT_LE(std::abs(step.y()), 0.25 * std::abs(step.x()));
            EXPECT_TRUE(c == LineClass::Inner || std::abs(points[i].position.x()) > 10 ||
                        points[i].position.y() == 0);
        }
    }
}

TEST(Chaining, GoesAroundCorners) {
    EXPECT_EQ(strokes({towards(0, 180), towards(0, 100)}), 1u);
    EXPECT_EQ(strokes({towards(0, 180), towards(0, 120)}), 2u);  // a hairpin
    EXPECT_EQ(strokes({towards(0, 180), towards(0.3, 100)}), 2u);
    const DrawnLine contour = towards(0, 180, LineClass::Contour);
    EXPECT_EQ(strokes({contour, towards(0, 100, LineClass::Contour)}), 2u);
    const auto chained = chain({towards(0, 180), towards(0, 100), towards(0, 30)}, pens, false);
    ASSERT_EQ(chained.size(), 2u);  // what goes straight on comes first
    EXPECT_NEAR(lengthOf(chained[0].points), 18, 0.1);
}

TEST(ViewDrawing, JoinsWhatOnlyALineThatIsLeftOutHasParted) {
    const auto inner_paths = [](const DrawnLine& between) {
        DrawnView view{parseViews("front", UpAxis::Y)[0], {Vector2d(0, -5), Vector2d(20, 5)}};
        view.lines = {straight({0, 0}, {9, 0}), between, straight({10.5, 0}, {20, 0})};
        std::size_t paths = 0;
        for (const SheetLayer& layer : drawView(view, 1, {1, {0, 0}}, {}, {}).layers)
            if (layer.key == "inner") paths += layer.paths.size();
        return paths;
    };
    EXPECT_EQ(inner_paths(straight({9.75, -3}, {9.75, 3})), 3u);
    EXPECT_EQ(inner_paths(straight({9.75, -0.5}, {9.75, 0.5})), 1u);
}

TEST(Chaining, KeepsAllPointsInOrder) {
    const auto chained = chain(
        {straight({10.2, 0}, {20, 0}), straight({0, 0}, {10, 0}), straight({30, 0}, {20.1, 0})},
        pens, false);
    ASSERT_EQ(chained.size(), 1u);
    const bool rises = chained[0].points.front().position.x() < 1;
    for (std::size_t i = 1; i < chained[0].points.size(); ++i) {
        const double step =
            chained[0].points[i].position.x() - chained[0].points[i - 1].position.x();
        EXPECT_GT(rises ? step : -step, 0);
    }
    EXPECT_NEAR(lengthOf(chained[0].points), 30, 1e-9);
}

TEST(Chaining, ClosesARingOfTwoHalves) {
    DrawnLine whole = circle(40), first{LineClass::Inner, false, {}}, second = first;
    first.points.assign(whole.points.begin(), whole.points.begin() + 51);
    second.points.assign(whole.points.begin() + 50, whole.points.end());
    const auto chained = chain({first, second}, pens, false);
    ASSERT_EQ(chained.size(), 1u);
    EXPECT_TRUE(chained[0].closed);
    EXPECT_EQ(chained[0].points.front().position, chained[0].points.back().position);
}

TEST(Chaining, PassesFromAContourToALineWithOneWidth) {
    const DrawnLine contour = straight({0, 0}, {10, 0}, 1, LineClass::Contour);
    const DrawnLine line = straight({10.1, 0}, {20, 0}, 0.8);
    EXPECT_EQ(strokes({contour, line}), 2u);
    const DrawnLine next = straight({10, 0}, {20, 0}, 1, LineClass::Contour);
    EXPECT_EQ(strokes({contour, next}), 1u);
    const auto chained = chain({contour, line}, pens, true);
    ASSERT_EQ(chained.size(), 1u);
    EXPECT_EQ(chained[0].line_class, LineClass::Contour);
    for (std::size_t i = 1; i < chained[0].points.size(); ++i)  // no step
        EXPECT_NEAR(chained[0].points[i].weight, chained[0].points[i - 1].weight, 0.15);
    const auto& [first, last] =
        std::minmax(chained[0].points.front().weight, chained[0].points.back().weight);
    EXPECT_NEAR(first, 0.8 * 0.25 / 0.35, 1e-9);
    EXPECT_EQ(last, 1);
}

TEST(Chaining, LeavesEdgesAndOutlinesAlone) {
    for (const LineClass c : {LineClass::Outline, LineClass::Edge, LineClass::Section})
        EXPECT_EQ(
            strokes({straight({0, 0}, {10, 0}, 1, c), straight({10.1, 0}, {20, 0}, 1, c)}, true),
            2u);
}

}  // namespace
