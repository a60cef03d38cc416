// SPDX-License-Identifier: GPL-3.0-or-later
// White between lines, folds by families, and what is joined to one stroke.
#include "strokes/strokes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace line_drawing;
using Eigen::Vector2d;

namespace {

constexpr auto kPens = pens_of(Weights::Illustrator);
constexpr double kPen = 0.25;  // mm, of inner lines

/// Points at most .1 mm apart.
DrawnLine straight(const Vector2d& from, const Vector2d& to, double weight = 1,
                   LineClass line_class = LineClass::Inner) {
    DrawnLine line{line_class, false, {}};
    const int steps = int(std::ceil((to - from).norm() / 0.1));
    for (int i = 0; i <= steps; ++i)
        line.points.push_back({from + double(i) / steps * (to - from), weight,
                               laplacian_lines::kNoNode, line_class == LineClass::Edge});
    return line;
}

DrawnLine circle(double circumference) {
    DrawnLine line{LineClass::Inner, true, {}};
    const double radius = circumference / (2 * M_PI);
    for (int i = 0; i <= 100; ++i) {
        const double angle = 2 * M_PI * (i % 100) / 100;
        line.points.push_back({radius * Vector2d(std::cos(angle), std::sin(angle)), 1,
                               laplacian_lines::kNoNode, false});
    }
    return line;
}

double length_of_all(const std::vector<DrawnLine>& lines) {
    double sum = 0;
    for (const DrawnLine& line : lines)
        sum += length_of(line.points);
    return sum;
}

TEST(Thinning, LeavesTheStrongerOfTwoLinesSideBySide) {
    const auto thinned =
        thin_out({straight({0, 0}, {20, 0}, 0.5), straight({0, 0.3}, {20, 0.3})}, kPens);
    ASSERT_EQ(thinned.size(), 1u);
    EXPECT_EQ(thinned[0].points[0].position.y(), 0.3);
    for (const auto& [distance, count] : {std::pair(2.9 * kPen, 1u), std::pair(3.1 * kPen, 2u)})
        EXPECT_EQ(
            thin_out({straight({0, 0}, {20, 0}), straight({0, distance}, {20, distance})}, kPens)
                .size(),
            count);
}

/// Edges stay beside an outline, also where a point of theirs is none of an edge.
TEST(Thinning, LeavesContoursThatAreEdges) {
    DrawnLine contour = straight({0, 0.4}, {20, 0.4}, 1, LineClass::Contour);
    const auto count = [&] {
        return thin_out({straight({0, 0}, {20, 0}, 1, LineClass::Outline), contour}, kPens).size();
    };
    EXPECT_EQ(count(), 1u) << "of a curved surface";
    for (DrawnPoint& point : contour.points)
        point.is_exact = &point != &contour.points[7];
    EXPECT_EQ(count(), 2u);
}

TEST(Thinning, LeavesLinesThatCrossOrMeet) {
    const std::vector<DrawnLine> lines = {straight({0, 0}, {20, 0}), straight({10, -8}, {10, 8}),
                                          straight({5, 0.04}, {5, 9})};
    EXPECT_NEAR(length_of_all(thin_out(lines, kPens)), length_of_all(lines), 1e-9);
}

TEST(Thinning, LeavesARingWhereALineCrossesItsBegin) {
    const DrawnLine ring = circle(60 * kPen);
    for (const double off : {0., 0.5, 1., 15.}) {
        const double y = off * kPen;
        const std::vector<DrawnLine> lines = {ring, straight({0.5, y}, {24, y})};
        const auto thinned = thin_out(lines, kPens);
        ASSERT_EQ(thinned.size(), 2u) << off;
        EXPECT_NEAR(length_of_all(thinned), length_of_all(lines), 1e-9) << off;
    }
}

TEST(Thinning, TakesAwayOnlyThePartBesideAnotherLine) {
    const auto thinned =
        thin_out({straight({0, 0}, {20, 0}), straight({10, 0.2}, {30, 0.2}, 0.5)}, kPens);
    ASSERT_EQ(thinned.size(), 2u);
    EXPECT_NEAR(length_of(thinned[1].points), 10, 0.7);
}

TEST(Thinning, LeavesWhiteBesideOutlinesAndEdgesWhichStay) {
    for (const LineClass c : {LineClass::Outline, LineClass::Contour, LineClass::Edge}) {
        const double touching = kPens[std::size_t(c)] / 2 + kPen / 2;
        const auto left = [&](double white, double rise) {
            const double y = touching + white * kPen;
            return length_of_all(
                       thin_out({straight({0, 0}, {20, 0}, 1, c), straight({0, y}, {20, y + rise})},
                                kPens)) -
                   20;
        };
        EXPECT_EQ(left(1.4, 0), 0);
        EXPECT_NEAR(left(1.6, 0), 20, 1e-9);
        EXPECT_NEAR(left(0.6, kPen), 20, 0.1);  // whole, or not at all
        EXPECT_EQ(left(0.6, 0.8 * kPen), 0);
    }
}

TEST(Thinning, LeavesWhiteBetweenCrowdedEdges) {
    const auto left = [&](int count, double distance) {
        std::vector<DrawnLine> lines;
        for (const double x : {0., 4.})  // which they lead from one to the other
            lines.push_back(straight({x, -1}, {x, 4}, 1, LineClass::Outline));
        for (int i = 0; i < count; ++i)
            lines.push_back(straight({0, distance * i}, {4, distance * i}, 1, LineClass::Edge));
        lines = thin_out(lines, kPens);
        std::vector<double> heights;
        for (const DrawnLine& line : lines)
            if (line.line_class == LineClass::Edge) heights.push_back(line.points[0].position.y());
        std::sort(heights.begin(), heights.end());
        return heights;
    };
    EXPECT_EQ(left(2, 0.26).size(), 2u);  // a chamfer
    EXPECT_EQ(left(9, 0.38).size(), 9u);
    const std::vector<double> crowd = left(9, 0.26);
    EXPECT_EQ(crowd.front(), 0);
    EXPECT_EQ(crowd.back(), 8 * 0.26);
    EXPECT_EQ(crowd.size(), 5u);
    for (std::size_t i = 1; i < crowd.size(); ++i)
        EXPECT_GT(crowd[i] - crowd[i - 1], 1.5 * kPen);
}

TEST(Classes, AreOneWhereEdgesAndContoursContinueEachOther) {
    const auto edge = [](double x, double length, LineClass c) {
        return straight({x, 0}, {x + length, 0}, 1, c);
    };
    constexpr auto e = LineClass::Edge, c = LineClass::Contour;
    const auto classes = [](std::vector<DrawnLine> lines) {
        even_out_classes(lines, 0.2);
        std::vector<LineClass> found;
        for (const DrawnLine& line : lines)
            found.push_back(line.line_class);
        return found;
    };
    using Classes = std::vector<LineClass>;
    EXPECT_EQ(classes({edge(0, 5, e), edge(5, 3, c), edge(8.1, 9, e)}), Classes(3, e));
    EXPECT_EQ(classes({edge(0, 5, c), edge(5, 3, e), edge(8.1, 9, c)}), Classes(3, c));
    EXPECT_EQ(classes({edge(0, 5, e), straight({5, 0}, {7, 9}, 1, c)}), Classes({e, c}));
    EXPECT_EQ(classes({edge(0, 5, e), edge(5.3, 9, c)}), Classes({e, c}));
}

TEST(Thinning, LeavesOutWhatIsTooShortToBeSeen) {
    EXPECT_TRUE(thin_out({straight({0, 0}, {5.9 * kPen, 0})}, kPens).empty());
    EXPECT_EQ(thin_out({straight({0, 0}, {6.1 * kPen, 0})}, kPens).size(), 1u);
    DrawnLine folded = straight({0, 0}, {3.5 * kPen, 0});
    folded.points.push_back({{0, 0.5 * kPen}, 1, laplacian_lines::kNoNode, false});
    EXPECT_TRUE(thin_out({folded}, kPens).empty());
    EXPECT_TRUE(thin_out({circle(23 * kPen)}, kPens).empty());
    EXPECT_EQ(thin_out({circle(25 * kPen)}, kPens).size(), 1u);
}

/// How many stay, of which those that meet nothing and are below 4 mm are fragments.
std::size_t whole(const std::vector<DrawnLine>& lines) {
    return without_fragments(lines, 4, kPen).size();
}

TEST(Fragments, AreShortAndMeetNothing) {
    for (const LineClass c : {LineClass::Inner, LineClass::Contour}) {
        const DrawnLine fragment = straight({0, 0}, {3.9, 0}, 1, c);
        EXPECT_EQ(whole({fragment}), 0u);
        EXPECT_EQ(whole({straight({0, 0}, {4.1, 0}, 1, c)}), 1u);
        EXPECT_EQ(whole({fragment, straight({4.2, -9}, {4.2, 9})}), 2u);  // meets
        EXPECT_EQ(whole({fragment, straight({4.6, -9}, {4.6, 9})}), 1u);
    }
    EXPECT_EQ(whole({straight({0, 0}, {3.9, 0}, 1, LineClass::Edge)}), 1u);
    EXPECT_EQ(whole({circle(7.9)}), 0u);
    EXPECT_EQ(whole({circle(8.1)}), 1u);
}

TEST(Fragments, AreContoursThatLeadNowhere) {
    const DrawnLine tick = straight({0, 0}, {1.4, 0}, 1, LineClass::Contour),
                    first = straight({0, -9}, {0, 9}, 1, LineClass::Contour),
                    second = straight({1.4, -9}, {1.4, 9}, 1, LineClass::Outline);
    EXPECT_EQ(whole({tick, first, second}), 3u);
    EXPECT_EQ(whole({tick, first}), 1u);
    EXPECT_EQ(whole({tick, straight({0, 0.3}, {9, 0.3}, 1, LineClass::Contour)}), 1u);  // beside
    EXPECT_EQ(whole({tick, first, straight({1.4, -9}, {1.4, 9})}), 2u);  // to an inner line
}

TEST(Fragments, AreHolesThatWouldBeDots) {
    for (const auto kind : {laplacian_lines::LineKind::Border, laplacian_lines::LineKind::Crease})
        for (const double length : {1., 1.2}) {  // two pens, corner to corner: 1.11
            DrawnLine ring = circle(length);
            ring.line_class = LineClass::Contour;
            ring.kind = kind;
            for (DrawnPoint& point : ring.points)
                point.is_exact = true;
            const bool is_dot = kind == laplacian_lines::LineKind::Border && length < 1.1;
            EXPECT_EQ(whole({ring}), is_dot ? 0u : 1u);
        }
}

TEST(Fragments, AreNoStrokesOfATexture) {
    const DrawnLine fragment = straight({0, 0}, {3, 0});
    EXPECT_EQ(whole({fragment, straight({0, 2.5}, {3, 2.5})}), 2u);
    EXPECT_EQ(whole({fragment, straight({0, 3.5}, {3, 3.5})}), 0u);    // too far away
    EXPECT_EQ(whole({fragment, straight({1, 2.5}, {2.2, 2.5})}), 0u);  // unlike
    EXPECT_EQ(whole({fragment, straight({1.5, 1}, {1.5, 3.5})}), 0u);  // across
}

std::size_t strokes(const std::vector<DrawnLine>& lines, bool with_contours = false) {
    return chain(lines, kPens, with_contours).size();
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

/// 9 mm from (x, 0) on, turned from the x axis towards y.
DrawnLine towards(double x, double degrees, LineClass line_class = LineClass::Inner) {
    const double a = degrees * M_PI / 180;
    return straight({x, 0}, Vector2d(x, 0) + 9 * Vector2d(std::cos(a), std::sin(a)), 1, line_class);
}

TEST(Chaining, GoesAroundCorners) {
    EXPECT_EQ(strokes({towards(0, 180), towards(0, 100)}), 1u);
    EXPECT_EQ(strokes({towards(0, 180), towards(0, 120)}), 2u);  // a hairpin
    EXPECT_EQ(strokes({towards(0, 180), towards(0.3, 100)}), 2u);
    const DrawnLine contour = towards(0, 180, LineClass::Contour);
    EXPECT_EQ(strokes({contour, towards(0, 100, LineClass::Contour)}), 2u);
    const auto chained = chain({towards(0, 180), towards(0, 100), towards(0, 30)}, kPens, false);
    ASSERT_EQ(chained.size(), 2u);  // what goes straight on comes first
    EXPECT_NEAR(length_of(chained[0].points), 18, 0.1);
}

/// Of 4 mm and 115°: from (x, 0) along the x axis, or against it, then to the given side of it.
DrawnLine arc(double x, double side, bool is_towards) {
    DrawnLine line{LineClass::Inner, false, {}};
    for (double angle = 0; angle <= 2; angle += 0.05) {
        const Vector2d p(2 * std::sin(angle), side * 2 * (1 - std::cos(angle)));
        line.points.push_back(
            {{x + (is_towards ? -1 : 1) * p.x(), p.y()}, 1, laplacian_lines::kNoNode, false});
    }
    return line;
}

TEST(Chaining, LeavesCurlsApart) {
    for (const double gap : {0., 0.4, 1.}) {
        EXPECT_EQ(strokes({arc(0, 1, true), arc(gap, 1, false)}), 1u) << gap;
        EXPECT_EQ(strokes({arc(0, 1, true), arc(gap, -1, false)}), 2u) << gap;
        EXPECT_EQ(strokes({arc(0, 1, true), straight({gap, 0}, {gap + 9, 0})}), 1u) << gap;
    }
}

TEST(Chaining, JoinsContoursOverGapsThatNothingEndsIn) {
    const DrawnLine first = straight({0, 0}, {10, 0}, 1, LineClass::Contour),
                    second = straight({11.5, 0}, {20, 0}, 1, LineClass::Contour);
    EXPECT_EQ(strokes({first, second}, true), 1u);
    EXPECT_EQ(strokes({first, second}), 2u);
    EXPECT_EQ(strokes({first, straight({11.5, 0}, {20, 0})}, true), 1u);
    const DrawnLine over = straight({10, -3}, {10, 3}, 1, LineClass::Contour);
    EXPECT_EQ(strokes({first, second, over}, true), 3u);
    DrawnLine edge = second;
    for (DrawnPoint& point : edge.points)
        point.is_exact = true;
    EXPECT_EQ(strokes({first, edge}, true), 2u);
}

TEST(Chaining, ClosesARingOfTwoHalves) {
    DrawnLine whole = circle(40), first{LineClass::Inner, false, {}}, second = first;
    first.points.assign(whole.points.begin(), whole.points.begin() + 51);
    second.points.assign(whole.points.begin() + 50, whole.points.end());
    const auto chained = chain({first, second}, kPens, false);
    ASSERT_EQ(chained.size(), 1u);
    EXPECT_TRUE(chained[0].closed);
    EXPECT_EQ(chained[0].points.front().position, chained[0].points.back().position);
}

/// Also of one line whose ends overshoot each other. Its seam is as smooth as others are.
TEST(Chaining, ClosesARingWithoutAStep) {
    DrawnLine line{LineClass::Contour, false, {}};
    line.kind = laplacian_lines::LineKind::Border;
    for (double angle = -0.03; angle < 6.31; angle += 0.04)
        line.points.push_back({{6 * std::cos(angle), 6 * std::sin(angle)}, angle < 3 ? 1. : 0.6});
    const auto chained = chain({line}, kPens, true);
    ASSERT_EQ(chained.size(), 1u);
    ASSERT_TRUE(chained[0].closed);
    EXPECT_EQ(chained[0].kind, laplacian_lines::LineKind::Border);
    const std::vector<DrawnPoint>& points = chained[0].points;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const Vector2d before = points[i].position - points[i - 1].position,
                       after = points[i + 1].position - points[i].position;
        EXPECT_GT(before.dot(after), 0.9 * before.norm() * after.norm()) << i;
    }
    const auto at_seam = std::min_element(points.begin(), points.end(), [](auto& a, auto& b) {
        return (a.position - Vector2d(6, 0)).norm() < (b.position - Vector2d(6, 0)).norm();
    });
    EXPECT_NEAR(at_seam->weight, 0.8, 0.15);
}

TEST(Chaining, PassesFromAContourToALineWithOneWidth) {
    const DrawnLine contour = straight({0, 0}, {10, 0}, 1, LineClass::Contour);
    const DrawnLine line = straight({10.1, 0}, {20, 0}, 0.8);
    EXPECT_EQ(strokes({contour, line}), 2u);
    const DrawnLine next = straight({10, 0}, {20, 0}, 1, LineClass::Contour);
    EXPECT_EQ(strokes({contour, next}), 1u);
    const auto chained = chain({contour, line}, kPens, true);
    ASSERT_EQ(chained.size(), 1u);
    EXPECT_EQ(chained[0].line_class, LineClass::Contour);
    for (std::size_t i = 1; i < chained[0].points.size(); ++i)  // no step
        EXPECT_NEAR(chained[0].points[i].weight, chained[0].points[i - 1].weight, 0.15);
    const auto& [first, last] =
        std::minmax(chained[0].points.front().weight, chained[0].points.back().weight);
    EXPECT_NEAR(first, 0.8 * 0.25 / 0.35, 1e-9);
    EXPECT_EQ(last, 1);
}

/// Grooves of a vessel with walls r(z) = 30 + 2 cos(z / 20), from 15° above: lines at even heights,
/// this many pens apart, slightly stronger or weaker than their neighbours.
std::vector<DrawnLine> rings(int count, double pens_apart) {
    std::vector<DrawnLine> lines;
    for (int ring = 0; ring < count; ++ring) {
        DrawnLine line{LineClass::Inner, false, {}};
        const double height = ring * pens_apart * kPen / std::cos(0.26);
        const double radius = 30 + 2 * std::cos(height / 20);
        for (double angle = 0.6; angle < 2.55; angle += 0.01)
            line.points.push_back(
                {{radius * std::cos(angle),
                  height * std::cos(0.26) - radius * std::sin(angle) * std::sin(0.26)},
                 0.9 + 0.1 * std::sin(12.9898 * (ring + 1)),
                 laplacian_lines::kNoNode,
                 false});
        lines.push_back(std::move(line));
    }
    return lines;
}

/// The numbers of a family's lines that are left, all whole.
std::vector<std::size_t> whole_of(const std::vector<DrawnLine>& family) {
    std::vector<std::size_t> whole;
    const auto thinned = thin_out(family, kPens);
    for (std::size_t i = 0; i < family.size(); ++i)
        for (const DrawnLine& line : thinned)
            if (line.points.front().position == family[i].points.front().position &&
                line.points.back().position == family[i].points.back().position)
                whole.push_back(i);
    EXPECT_EQ(whole.size(), thinned.size()) << "islands";
    return whole;
}

TEST(Families, AreDrawnEvenlyTheSmallerTheFewer) {
    for (const auto& [pens_apart, every] : {std::pair(6., 1u), {3.5, 1u}, {1.75, 2u}, {1.2, 3u}}) {
        const auto whole = whole_of(rings(24, pens_apart));
        ASSERT_GE(whole.size(), 24 / every - 1) << pens_apart;
        for (std::size_t i = 1; i < whole.size(); ++i)
            EXPECT_EQ(whole[i] - whole[i - 1], every) << pens_apart << ": " << whole[i];
    }
}

}  // namespace
