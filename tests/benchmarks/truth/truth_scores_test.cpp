// SPDX-License-Identifier: GPL-3.0-or-later
// Scores of made-up lines are known.
#include "truth_scores.h"

#include <gtest/gtest.h>

#include "plane_lines.h"
#include "truth_table.h"

namespace {

using namespace benchmarks;

constexpr double tolerance = 0.25;

PlaneLine straight(double x1, double y1, double x2, double y2) {
    return {{x1, y1}, {x2, y2}};
}

PlaneLine circle(double radius, int count = 720) {
    PlaneLine line;
    for (int i = 0; i <= count; ++i) {
        const double angle = 2 * M_PI * (i % count) / count;
        line.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return line;
}

DrawnPaths drawn(const PlaneLines& lines) {
    DrawnPaths paths;
    for (const PlaneLine& line : lines)
        paths.push_back({line, true, line.front() == line.back()});
    return paths;
}

const PlaneLines square = {straight(0, 0, 20, 0), straight(20, 0, 20, 20), straight(20, 20, 0, 20),
                           straight(0, 20, 0, 0)};

TruthScores score_of(const PlaneLines& lines, const PlaneLines& demanded,
                     const PlaneLines& allowed = {}) {
    return score(drawn(lines), {demanded, allowed}, tolerance);
}

TEST(NearSegments, KnowTheDistanceOfTheNearestLine) {
    const NearSegments near({straight(0, 0, 100, 0), straight(0, 1, 100, 2)}, 0.5);
    EXPECT_NEAR(near.distance({50, 0.3}), 0.3, 1e-12);
    EXPECT_NEAR(near.distance({0, 0.7}), 0.3, 1e-3);
    EXPECT_NEAR(near.distance({-0.3, 0.4}), 0.5, 1e-12);
    EXPECT_TRUE(std::isinf(near.distance({50, 0.6})));
}

TEST(NearSegments, FindLongSegmentsAnywhereAlongThem) {
    const NearSegments near({straight(-3, -7, 41, 59)}, 0.05);
    for (double t = 0; t <= 1; t += 0.001)
        EXPECT_LT(near.distance({-3 + 44 * t + 0.02, -7 + 66 * t - 0.02}), 0.05) << t;
}

TEST(TruthScores, AreOneForTheExactLinesThemselves) {
    const TruthScores scores = score_of(square, square);
    EXPECT_DOUBLE_EQ(scores.recall(), 1);
    EXPECT_DOUBLE_EQ(scores.precision(), 1);
    EXPECT_NEAR(scores.rms(), 0, 1e-9);
    EXPECT_EQ(scores.doubled, 0);
    EXPECT_EQ(scores.loose_ends, 0);
    EXPECT_EQ(scores.ends, 8);
}

TEST(TruthScores, KnowWhatIsMissed) {
    const TruthScores scores = score_of({square[0], square[1], square[2]}, square);
    EXPECT_NEAR(scores.recall(), 0.75, 0.01);
    EXPECT_DOUBLE_EQ(scores.precision(), 1);
}

TEST(TruthScores, OfNoDrawingIsNoRecall) {
    EXPECT_EQ(score_of({}, square).recall(), 0);
}

TEST(TruthScores, KnowWhatIsWrong) {
    PlaneLines lines = square;
    lines.push_back(straight(5, 10, 15, 10));
    const TruthScores scores = score_of(lines, square);
    EXPECT_DOUBLE_EQ(scores.recall(), 1);
    EXPECT_NEAR(scores.precision(), 80. / 90, 1e-6);
}

TEST(TruthScores, TakeWhatIsAllowedForRightAndDemandItNot) {
    const PlaneLine tangent = straight(5, 10, 15, 10);
    PlaneLines lines = square;
    EXPECT_DOUBLE_EQ(score_of(lines, square, {tangent}).recall(), 1);
    lines.push_back(tangent);
    EXPECT_DOUBLE_EQ(score_of(lines, square, {tangent}).precision(), 1);
}

TEST(TruthScores, TellHowFarAsideLinesAre) {
    const TruthScores near = score_of({straight(0, 0.2, 20, 0.2)}, {square[0]});
    EXPECT_DOUBLE_EQ(near.recall(), 1);
    EXPECT_NEAR(near.rms(), 0.2, 1e-9);
    const TruthScores far = score_of({straight(0, 0.3, 20, 0.3)}, {square[0]});
    EXPECT_EQ(far.recall(), 0);
    EXPECT_EQ(far.precision(), 0);
}

TEST(TruthScores, CountWhatIsDrawnTwice) {
    PlaneLines lines = square;
    lines.push_back(straight(5, 0.05, 15, 0.05));
    EXPECT_NEAR(score_of(lines, square).doubled, 20, 0.3);  // of both
    lines.back() = straight(5, 0.15, 15, 0.15);
    EXPECT_EQ(score_of(lines, square).doubled, 0);
}

TEST(TruthScores, TakeNoCrossingAndNoContinuationForDoubles) {
    EXPECT_EQ(score_of({straight(0, 0, 20, 0), straight(10, -5, 10, 5)}, square).doubled, 0);
    EXPECT_EQ(score_of({straight(0, 0, 10, 0), straight(10, 0, 20, 0)}, square).doubled, 0);
    EXPECT_GT(score_of({straight(0, 0, 10, 0), straight(8, 0, 20, 0)}, square).doubled, 3.5);
}

TEST(TruthScores, CountLooseEnds) {
    const PlaneLines gap = {straight(0, 0, 20, 0), straight(20, 0.1, 20, 20)};
    EXPECT_EQ(score_of(gap, square).loose_ends, 4);
    const PlaneLines corner = {straight(0, 0, 20, 0), straight(20, 0.04, 20, 20)};
    EXPECT_EQ(score_of(corner, square).loose_ends, 2);
    const PlaneLines junction = {straight(0, 0, 20, 0), straight(10, 0.01, 10, 10)};
    EXPECT_EQ(score_of(junction, square).loose_ends, 3);
}

TEST(TruthScores, TakeEndsOfExactLinesForTrueOnes) {
    const PlaneLines exact = {straight(0, 0, 20, 0)};
    EXPECT_EQ(score_of({straight(0, 0, 19.6, 0)}, exact).loose_ends, 0);
    EXPECT_EQ(score_of({straight(0, 0, 19, 0)}, exact).loose_ends, 1);
    // Where two exact lines meet, none ends.
    EXPECT_EQ(score_of({straight(0, 0, 10, 0)}, {straight(0, 0, 10, 0), straight(10, 0, 20, 0)})
                  .loose_ends,
              1);
}

/// Of a hole's rim, which pens draw as one line.
TEST(TruthScores, TakeTheTipsOfASliverForTrueEnds) {
    PlaneLines halves(2);
    for (int i = 0; i <= 100; ++i) {
        const double angle = M_PI * i / 100;
        for (const int sign : {1, -1})
            halves[sign > 0].push_back({10 * std::cos(angle), sign * 0.1 * std::sin(angle)});
    }
    EXPECT_EQ(score_of({halves[0]}, halves).loose_ends, 0);
    halves.push_back(straight(10, 0, 10, 20));  // leads on from one of them
    EXPECT_EQ(score_of({halves[0]}, halves).loose_ends, 1);
    halves.back() = straight(10, 0, 30, 0);
    EXPECT_EQ(score_of({halves[0]}, halves).loose_ends, 1);
}

TEST(TruthScores, CountClosedOutlines) {
    DrawnPaths paths = drawn({circle(10), straight(0, 0, 5, 0)});
    paths.push_back({circle(5), false, true});  // not on the layer of outlines
    const PlaneLines none;
    const TruthScores scores = score(paths, {none, none}, tolerance);
    EXPECT_EQ(scores.outlines, 2);
    EXPECT_EQ(scores.closed_outlines, 1);
    EXPECT_EQ(scores.ends, 2);
}

TEST(TruthDetails, ShowEachMistakeInOnePiece) {
    TruthDetails details;
    const PlaneLines lines = {straight(0, 0, 12, 0), straight(0, 5, 7, 5)}, none;
    score(drawn(lines), {{square[0]}, none}, tolerance, 0, &details);
    EXPECT_NEAR(details.longest_missed, 7.75, 0.15);
    EXPECT_NEAR(details.longest_wrong, 7, 1e-9);
    ASSERT_EQ(details.parts.size(), 2u);
    EXPECT_EQ(details.parts[0].mistake, Mistake::Missed);
    EXPECT_NEAR(details.parts[0].points.front().x(), 12.25, 0.1);
    EXPECT_EQ(details.parts[1].mistake, Mistake::Wrong);
    EXPECT_EQ(details.loose_ends.size(), 3u);
}

TEST(TruthMeans, AreOfDrawingsNotOfLengths) {
    const auto scored = [](double demanded, double found) {
        ScoredDrawing drawing;
        drawing.scores.demanded = demanded;
        drawing.scores.found = found;
        return drawing;
    };
    const TruthMeans means({scored(1000, 1000), scored(10, 5)});
    EXPECT_DOUBLE_EQ(means.recall, 0.75);
    EXPECT_DOUBLE_EQ(means.least_recall, 0.5);
}

}  // namespace
