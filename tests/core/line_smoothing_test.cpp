// SPDX-License-Identifier: GPL-3.0-or-later
// Smoothing of the lines' course.
#include <gtest/gtest.h>

#include "made_up_line.h"

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

/// Sum of the squares of second differences, which smoothing makes smaller.
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

TEST(LineSmoothing, LeavesStraightLinesStraight) {
    LineStyle style = helpers::all_laplacian_lines();
    style.line_smoothing = 3;
    for (const LinePoint& p : MadeUp().lines(style).points)
        EXPECT_NEAR(p.position.x(), MadeUp().offset, 1e-6);
}

}  // namespace
