// SPDX-License-Identifier: GPL-3.0-or-later
// Scores of drawings with known faults: they fall if a line is missing or added.
#include <gtest/gtest.h>

#include "test_paths.h"
#include "truth_measures.h"

namespace {

using namespace benchmarks;
using laplacian_lines::TriangleMesh;

constexpr double kTolerance = 0.25;

PlaneLine straight(double x1, double y1, double x2, double y2) {
    return {{x1, y1}, {x2, y2}};
}

const PlaneLines kSquare = {straight(0, 0, 20, 0), straight(20, 0, 20, 20), straight(20, 20, 0, 20),
                            straight(0, 20, 0, 0)};

TruthScores score_of(const PlaneLines& drawing, const PlaneLines& allowed = {}) {
    return score(drawing, kSquare, allowed, kTolerance);
}

TEST(TruthScores, AreOneForTheExactLinesThemselves) {
    const TruthScores scores = score_of(kSquare);
    EXPECT_DOUBLE_EQ(scores.recall, 1);
    EXPECT_DOUBLE_EQ(scores.precision, 1);
    EXPECT_EQ(scores.ends, 8);
    EXPECT_TRUE(scores.loose_ends.empty());
}

TEST(TruthScores, FallWhereALineIsMissing) {
    const TruthScores scores = score_of({kSquare[0], kSquare[1], kSquare[2]});
    EXPECT_NEAR(scores.recall, 0.75, 0.01);
    EXPECT_DOUBLE_EQ(scores.precision, 1);
    EXPECT_EQ(scores.loose_ends.size(), 2u);
    EXPECT_EQ(score_of({}).recall, 0);
}

TEST(TruthScores, FallWhereOneIsTooManyThatIsNotAllowed) {
    PlaneLines lines = kSquare;
    lines.push_back(straight(5, 10, 15, 10));
    EXPECT_NEAR(score_of(lines).precision, 80. / 90, 1e-6);
    EXPECT_EQ(score_of(lines).loose_ends.size(), 2u);
    EXPECT_DOUBLE_EQ(score_of(lines, {lines.back()}).precision, 1);
}

TEST(TruthScores, FallWhereALineIsAside) {
    PlaneLines lines = kSquare;
    lines[0] = straight(0, 0.2, 20, 0.2);
    EXPECT_DOUBLE_EQ(score_of(lines).recall, 1);
    lines[0] = straight(0, 0.3, 20, 0.3);
    EXPECT_NEAR(score_of(lines).recall, 0.75, 0.01);
    EXPECT_NEAR(score_of(lines).precision, 0.75, 0.01);
}

/// Of a hole's rim, which pens draw as one line.
TEST(TruthScores, TakeTheTipsOfASliverForTrueEnds) {
    PlaneLines halves(2);
    for (int i = 0; i <= 100; ++i)
        for (const int sign : {1, -1})
            halves[sign > 0].emplace_back(10 * std::cos(M_PI * i / 100),
                                          sign * 0.1 * std::sin(M_PI * i / 100));
    EXPECT_TRUE(score({halves[0]}, halves, {}, kTolerance).loose_ends.empty());
    halves.push_back(straight(10, 0, 10, 20));  // leads on from one of them
    EXPECT_EQ(score({halves[0]}, halves, {}, kTolerance).loose_ends.size(), 1u);
}

line_drawing::ViewFrame from_above() {
    line_drawing::ViewFrame frame;
    frame.side = line_drawing::Side::Other;
    frame.right = {1, 0, 0};
    frame.up = {0, 1, 0};
    frame.towards_viewer = {0, 0, 1};
    return frame;
}

void add_square(TriangleMesh& mesh, double z, double half) {
    const auto first = std::uint32_t(mesh.positions.size());
    for (const int x : {-1, 1})
        for (const int y : {-1, 1})
            mesh.positions.emplace_back(x * half, y * half, z);
    mesh.triangles.push_back({first, first + 2, first + 3});
    mesh.triangles.push_back({first, first + 3, first + 1});
}

PlaneLines outline(double half) {
    return {{{-half, -half}, {half, -half}, {half, half}, {-half, half}, {-half, -half}}};
}

TEST(ItemBuffer, HasTheBorderAndTheJumpsOfWhatIsInFront) {
    TriangleMesh mesh;
    add_square(mesh, 0, 5);
    add_square(mesh, 2, 2);
    const ItemBuffer items(mesh, from_above());
    EXPECT_NEAR(double(items.border().size()), 4 * 10 * ItemBuffer::kPixelsPerMm, 8);
    EXPECT_TRUE(bare_places(items.border(), outline(5), 0.1).empty());
    EXPECT_NEAR(double(items.jumps(0.5).size()), 4 * 4 * ItemBuffer::kPixelsPerMm, 8);
    EXPECT_TRUE(bare_places(items.jumps(0.5), outline(2), 0.1).empty());
    EXPECT_EQ(bare_places(items.jumps(0.5), outline(5), 0.1).size(), items.jumps(0.5).size());
    EXPECT_TRUE(items.jumps(2.5).empty());
    line_drawing::ViewFrame from_below = from_above();
    from_below.right = -from_below.right;
    from_below.towards_viewer = -from_below.towards_viewer;
    EXPECT_TRUE(ItemBuffer(mesh, from_below).jumps(0.5).empty());
}

TEST(FlatDrawing, IsInTheCoordinatesOfItsView) {
    TriangleMesh mesh;
    add_square(mesh, 1, 9);
    for (Eigen::Vector3d& p : mesh.positions)
        p += Eigen::Vector3d(7, -3, 0);
    const PlaneLines drawn = drawings_of(mesh, {from_above()}).at(0);
    PlaneLines square = outline(9);
    for (PlanePoint& p : square[0])
        p += PlanePoint(7, -3);
    const TruthScores scores = score(drawn, square, {}, 0.01);
    EXPECT_DOUBLE_EQ(scores.recall, 1);
    EXPECT_DOUBLE_EQ(scores.precision, 1);
}

TEST(PartFile, IsRefusedIfItIsNone) {
    EXPECT_THROW(read_part((test_paths::repository() / "LICENSE").string()), std::runtime_error);
    EXPECT_THROW(read_part("no_part"), std::runtime_error);
}

}  // namespace
