// SPDX-License-Identifier: GPL-3.0-or-later
// The default drawing of a head from a volume of labels against that of the smooth head.
#include <gtest/gtest.h>

#include "implicit_head.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/precompute.h"
#include "line_scores.h"

namespace {

using namespace benchmarks;
using namespace laplacian_lines;

constexpr int kVoxels = 80;

/// All kinds of lines, from an eye in front and to one side.
CurvePoints drawing(const TriangleMesh& mesh, const PrecomputeOptions& options, double step) {
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
    const CurvePoints right = drawing(smooth, {}, reach / 8);
    const auto f1 = [&](const PrecomputeOptions& options) {
        return compare(drawing(terraced, options, reach / 8), right, reach).f1();
    };
    PrecomputeOptions of_clean_meshes;
    of_clean_meshes.normal_sigma = automatic_normal_sigma(0);
    EXPECT_GT(f1({}), 0.82);
    EXPECT_GT(f1({}), f1(of_clean_meshes) + 0.05);
}

}  // namespace
