// SPDX-License-Identifier: GPL-3.0-or-later
// Which of several parallel folds are drawn.
#include "strokes/families.h"

#include <gtest/gtest.h>

#include <cmath>

#include "strokes/strokes.h"

using namespace line_drawing;
using Eigen::Vector2d;

namespace {

constexpr auto pens = pensOf(Weights::Illustrator);
constexpr double pen = 0.25;  // mm, of inner lines

/// Grooves of a vessel with walls r(z) = 30 + 2 cos(z / 20), from 15° above: lines at even heights,
/// this many pens apart, slightly stronger or weaker than their neighbours.
std::vector<DrawnLine> rings(int count, double pens_apart) {
    std::vector<DrawnLine> lines;
    for (int ring = 0; ring < count; ++ring) {
        DrawnLine line{LineClass::Inner, false, {}};
        const double height = ring * pens_apart * pen / std::cos(0.26);
        const double radius = 30 + 2 * std::cos(height / 20);
        for (double angle = 0.6; angle < 2.55; angle += 0.01)
            line.points.push_back(
                {{radius * std::cos(angle),
                  height * std::cos(0.26) - radius * std::sin(angle) * std::sin(0.26)},
                 0.9 + 0.1 * std::sin(12.9898 * (ring + 1)),
                 laplacian_lines::kNoSightNode,
                 false});
        lines.push_back(std::move(line));
    }
    return lines;
}

/// The lines of a family that are left, all whole.
std::vector<std::size_t> wholeOf(const std::vector<DrawnLine>& family) {
    std::vector<std::size_t> whole;
    const auto thinned = thinOut(family, pens);
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
        const auto whole = wholeOf(rings(24, pens_apart));
        ASSERT_GE(whole.size(), 24 / every - 1) << pens_apart;
        for (std::size_t i = 1; i < whole.size(); ++i)
            EXPECT_EQ(whole[i] - whole[i - 1], every) << pens_apart << ": " << whole[i];
    }
}

/// From x to x at a height, in pens.
DrawnLine fold(double begin, double end, double y, double rise = 0, double weight = 1) {
    DrawnLine line{LineClass::Inner, false, {}};
    for (double t = 0; t <= 1; t += 0.01)
        line.points.push_back({pen * Vector2d(begin + t * (end - begin), y + t * rise), weight,
                               laplacian_lines::kNoSightNode, false});
    return line;
}

/// Among three folds of 100 pens, 12 pens apart.
bool isLeft(const DrawnLine& line, int folds = 3, double rise = 0) {
    std::vector<DrawnLine> lines = {line};
    for (int i = 0; i < folds; ++i)
        lines.push_back(fold(0, 100, 12 * i, i > 0 ? rise : 0));
    return thinOut(lines, pens).size() == lines.size();
}

TEST(Families, HaveNoShortLinesBetweenThem) {
    EXPECT_FALSE(isLeft(fold(0, 50, 5)));
    EXPECT_FALSE(isLeft(fold(20, 80, 5)));
    EXPECT_TRUE(isLeft(fold(0, 90, 5)));              // one of them
    EXPECT_TRUE(isLeft(fold(0, 50, 5), 2));           // no family
    EXPECT_TRUE(isLeft(fold(0, 50, -5)));             // beside it
    EXPECT_TRUE(isLeft(fold(50, 100, 8, 4), 3, 20));  // where they part, it fills the gap
}

}  // namespace
