// SPDX-License-Identifier: GPL-3.0-or-later
// Scores of lines against arrises, options of line_truth, and a head's drawing from a label volume
// against the smooth one.
#include "line_scores.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "flaked_stone.h"
#include "implicit_head.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/precompute.h"
#include "truth_options.h"

namespace {

using namespace benchmarks;
using namespace laplacian_lines;
using Eigen::Vector3d;
using test_meshes::ArrisPiece;

LineSet drawn(const std::vector<ArrisPiece>& pieces, LineKind kind, float opacity = 1) {
    LineSet lines;
    for (const ArrisPiece& piece : pieces) {
        lines.lines.push_back({std::uint32_t(lines.points.size()), 2, kind});
        for (const Vector3d& p : {piece.a, piece.b})
            lines.points.push_back({p.cast<float>(), 1, 0, opacity});
    }
    return lines;
}

LineKindSet only(LineKind kind) {
    LineKindSet kinds;
    kinds[kind] = true;
    return kinds;
}

const LineKindSet kRidges = only(LineKind::Ridge);
constexpr Matching kMatching = {0.01, 0.1};

/// Pieces of 0.01 on the x axis.
std::vector<ArrisPiece> along_x(double from, double to, double angle = 90) {
    std::vector<ArrisPiece> pieces;
    for (double x = from; x < to - 1e-9; x += 0.01)
        pieces.push_back({{x, 0, 0}, {x + 0.01, 0, 0}, angle, Vector3d::UnitZ()});
    return pieces;
}

Score ridge_score(const LineSet& lines, const Truth& truth) {
    return score(lines, truth, kRidges, kRidges, kMatching);
}

TEST(LineScores, OfTheTruthItselfAreOne) {
    const test_meshes::FlakedStone stone({1});
    const auto arrises = find_arrises(stone, 8, 4);
    const Truth truth(arrises, 15, 8);
    ASSERT_FALSE(truth.blunt.empty());
    const Score score = ridge_score(drawn(truth.sharp, LineKind::Ridge), truth);
    EXPECT_DOUBLE_EQ(score.recall.value(), 1);
    EXPECT_DOUBLE_EQ(score.precision.value(), 1);
    EXPECT_DOUBLE_EQ(score.f1(), 1);
    EXPECT_NEAR(score.recall.all, total_length(truth.sharp), 1e-9 * score.recall.all);
}

TEST(LineScores, OfHalfOfTheTruthHaveARecallOfAHalf) {
    const Truth truth(along_x(0, 10), 15, 8);
    const Score score = ridge_score(drawn(along_x(0, 5), LineKind::Ridge), truth);
    EXPECT_NEAR(score.recall.value(), 0.5, 0.002);
    EXPECT_DOUBLE_EQ(score.precision.value(), 1);
    EXPECT_NEAR(score.f1(), 2 / 3., 0.002);
}

TEST(LineScores, KnowTheDistance) {
    const Truth truth(along_x(0, 1), 15, 8);
    for (const double distance : {0.0095, 0.0105}) {
        std::vector<ArrisPiece> beside = along_x(0, 1);
        for (ArrisPiece& piece : beside)
            piece.a.y() = piece.b.y() = -distance;
        const Score score = ridge_score(drawn(beside, LineKind::Ridge), truth);
        EXPECT_EQ(score.recall.value() > 0.5, distance < 0.01);
        EXPECT_EQ(score.precision.value() > 0.5, distance < 0.01);
    }
}

TEST(LineScores, LeaveBluntArrisesFree) {
    std::vector<ArrisPiece> arrises = along_x(0, 1, 30);
    for (const ArrisPiece& piece : along_x(1, 2, 10))
        arrises.push_back(piece);
    for (const ArrisPiece& piece : along_x(2, 3, 5))
        arrises.push_back(piece);
    const Truth truth(arrises, 15, 8);
    const Score all = ridge_score(drawn(arrises, LineKind::Ridge), truth);
    EXPECT_DOUBLE_EQ(all.recall.value(), 1);
    EXPECT_NEAR(all.recall.all, 1, 1e-9);
    EXPECT_NEAR(all.precision.value(), 2 / 3., 0.01);
    const Score sharp = ridge_score(drawn(along_x(0, 1), LineKind::Ridge), truth);
    EXPECT_DOUBLE_EQ(sharp.recall.value(), 1);
    EXPECT_DOUBLE_EQ(sharp.precision.value(), 1);
}

TEST(LineScores, CountWhatIsDrawnByTheKindsThatAreAskedFor) {
    const Truth truth(along_x(0, 1), 15, 8);
    const LineSet laplacian = drawn(along_x(0, 2), LineKind::Laplacian);
    EXPECT_EQ(ridge_score(laplacian, truth).recall.value(), 0);
    LineKindSet both = kRidges;
    both[LineKind::Laplacian] = true;
    const Score recalled = score(laplacian, truth, both, kRidges, kMatching);
    EXPECT_DOUBLE_EQ(recalled.recall.value(), 1);
    EXPECT_EQ(recalled.precision.all, 0) << "a Laplacian line need not be on an arris";
    const LineSet pale = drawn(along_x(0, 1), LineKind::Ridge, 0.05f);
    EXPECT_EQ(ridge_score(pale, truth).recall.value(), 0);
    EXPECT_TRUE(ridge_score(LineSet(), Truth({}, 15, 8)).is_empty());
}

TEST(LineScores, WantFromAnEyeWhatFacesIt) {
    std::vector<ArrisPiece> arrises = along_x(0, 1);
    for (ArrisPiece& piece : arrises)
        if (piece.a.x() < 0.495) piece.normal = -Vector3d::UnitZ();
    const Truth truth = Truth(arrises, 15, 8).facing({0, 0, 2});
    EXPECT_EQ(truth.sharp.size(), 50u);
    const Score all = ridge_score(drawn(arrises, LineKind::Ridge), truth);
    EXPECT_NEAR(all.recall.all, 0.5, 1e-9);
    EXPECT_DOUBLE_EQ(all.precision.value(), 1) << "what is on the other side may be drawn";
    arrises[0].convex = false;
    EXPECT_EQ(Truth(arrises, 15, 8).convex().sharp.size(), 99u);
}

TEST(LineScores, CompareDrawingsBothWays) {
    const LineKindSet all = LineKindSet::defaults();
    const auto points = [&](double from, double to) {
        return drawn_points(drawn(along_x(from, to), LineKind::Contour), all, 0.1, 0.001);
    };
    const Score score = compare(points(0, 4), points(0, 1), 0.005);
    EXPECT_DOUBLE_EQ(score.recall.value(), 1);
    EXPECT_NEAR(score.precision.value(), 0.25, 0.003);
    EXPECT_DOUBLE_EQ(compare(points(0, 4), points(5, 6), 0.005).f1(), 0);
}

constexpr int kVoxels = 80;

/// All kinds, from the front and one side.
CurvePoints drawing_of(const TriangleMesh& mesh, const PrecomputeOptions& options, double step) {
    const Field field = precompute(mesh, options);
    ExtractionScratch scratch;
    LineSet lines;
    LineExtractor(mesh, field)
        .extract(View::perspective(field.scale.diagonal * Eigen::Vector3d(0.5, 0.3, 1.4)),
                 LineStyle(), scratch, lines);
    return drawn_points(lines, LineKindSet::defaults(), 0.1, step);
}

TEST(Terraces, AreDrawnLikeTheSmoothForm) {
    const TriangleMesh smooth = test_meshes::smooth_head(kVoxels),
                       terraced = test_meshes::terraced_head(kVoxels);
    const double reach = 0.01 * measure_scale(smooth).diagonal;
    const CurvePoints right = drawing_of(smooth, {}, reach / 8);
    const auto f1 = [&](const PrecomputeOptions& options) {
        return compare(drawing_of(terraced, options, reach / 8), right, reach).f1();
    };
    PrecomputeOptions of_clean_meshes;
    of_clean_meshes.normal_sigma = automatic_normal_sigma(0);
    EXPECT_GT(f1({}), 0.82);
    EXPECT_GT(f1({}), f1(of_clean_meshes) + 0.05);
}

void refuse(const std::vector<std::string>& words) {
    TruthOptions options;
    parse_words(words, options.words());
    options.check();
}

TEST(TruthOptions, SetWhatTheirKeysName) {
    TruthOptions options;
    const auto files = parse_words(
        {"--set", "ridge_angle=30", "--set", "kernel_size=1.5%", "--set", "normal_sigma=1",
         "--only", "parts", "--seeds", "4,5", "--kinds", "ridges", "mesh.ply", "--reach", "2"},
        options.words());
    EXPECT_NO_THROW(options.check());
    EXPECT_EQ(options.style.ridge_angle, 30);
    EXPECT_DOUBLE_EQ(options.field_options(200).kernel_size, 3);
    EXPECT_EQ(options.field_options(200).normal_sigma, 1);
    EXPECT_EQ(options.only, "parts");
    EXPECT_EQ(options.seeds, std::vector<double>({4, 5}));
    EXPECT_TRUE(options.kinds[LineKind::Ridge]);
    EXPECT_FALSE(options.kinds[LineKind::Laplacian]);
    EXPECT_EQ(files, std::vector<std::string>({"mesh.ply"}));
    EXPECT_EQ(options.reach, 2);
}

TEST(TruthOptions, RefuseWhatTheyDoNotKnow) {
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"--set", "ridge_angel=30"},
                                               {"--set", "ridge_angle"},
                                               {"--set", "ridge_angle=a"},
                                               {"--set", "ridge_angle=5%"},
                                               {"--only", "bones"},
                                               {"--kinds", "ridge"},
                                               {"--resolutions", "2"},
                                               {"--voxels", "80.5"},
                                               {"--voxels", "0"},
                                               {"--seeds", "1,-1"},
                                               {"--reach", "0"},
                                               {"--seeds"},
                                               {"--seed", "1"}})
        EXPECT_THROW(refuse(arguments), std::invalid_argument) << arguments.back();
    EXPECT_THROW(refuse({"--set", "ridge_angle=-1"}), Error);
    EXPECT_THROW(refuse({"--set", "kernel_size=-1%"}), Error);
}

}  // namespace
