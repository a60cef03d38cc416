// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fixed/line_smoothing.h"
#include "made_up_line.h"
#include "rules/line_rules.h"

namespace {

using namespace laplacian_lines;
using helpers::MadeUp;

LineSet noisy_torus_lines(double smoothing) {
    static const TriangleMesh& mesh = test_meshes::mesh_named("torus_jittered").mesh;
    static const LineExtractor extractor(mesh, precompute(mesh));
    LineStyle style = helpers::all_crossings();
    style.line_smoothing = smoothing;
    return helpers::extract(extractor, View::perspective({3, 2, 4}), style);
}

/// Squares of second differences.
double roughness(const LineSet& set) {
    double sum = 0;
    for (const Polyline& line : set.lines)
        for (std::uint32_t i = line.first + 1; i + 1 < line.first + line.count; ++i)
            sum += (set.points[i - 1].position - 2 * set.points[i].position +
                    set.points[i + 1].position)
                       .squaredNorm();
    return sum;
}

TEST(LineSmoothing, MakesLinesSmoother) {
    EXPECT_LT(roughness(noisy_torus_lines(1.2)), roughness(noisy_torus_lines(0)) / 4);
    EXPECT_LT(roughness(noisy_torus_lines(3)), roughness(noisy_torus_lines(1.2)) / 2);
}

TEST(LineSmoothing, KeepsTheLinesAndTheirEnds) {
    const LineSet rough = noisy_torus_lines(0), smooth = noisy_torus_lines(2);
    ASSERT_EQ(smooth.lines.size(), rough.lines.size());
    bool has_closed = false;
    for (std::size_t i = 0; i < rough.lines.size(); ++i) {
        const Polyline &a = rough.lines[i], &b = smooth.lines[i];
        ASSERT_EQ(a.count, b.count);
        EXPECT_EQ(a.length, b.length);  // tests and strengths are those of the crossings
        const auto ends = [&](const LineSet& set) {
            return std::pair{set.points[a.first].position,
                             set.points[a.first + a.count - 1].position};
        };
        if (a.closed) {
            has_closed = true;
            EXPECT_EQ(ends(smooth).first, ends(smooth).second);
            EXPECT_NE(ends(smooth).first, ends(rough).first);
        } else {
            EXPECT_EQ(ends(smooth).first, ends(rough).first);
            EXPECT_EQ(ends(smooth).second, ends(rough).second);
        }
    }
    EXPECT_TRUE(has_closed);
}

/// A spike becomes a Gaussian of this deviation, in points.
TEST(LineSmoothing, HasTheDeviationAskedFor) {
    constexpr int kMiddle = 50;
    for (const double deviation : {1., 2., 3.}) {
        std::vector<double> at(2 * kMiddle + 1, 0);
        at[kMiddle] = 1;
        smooth_binomially(
            at.size(), false, smoothing_passes(deviation),
            [&](std::size_t i) -> double& { return at[i]; }, [](std::size_t) { return false; });
        double variance = 0;
        for (int i = 0; i <= 2 * kMiddle; ++i)
            variance += at[std::size_t(i)] * (i - kMiddle) * (i - kMiddle);
        EXPECT_NEAR(std::sqrt(variance), deviation, 1e-6);
    }
}

TEST(LineSmoothing, LeavesStraightLinesStraight) {
    LineStyle style = helpers::all_laplacian_lines();
    style.line_smoothing = 3;
    for (const LinePoint& p : MadeUp().lines(style).points)
        EXPECT_NEAR(p.position.x(), MadeUp().offset, 1e-6);
}

}  // namespace
