// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings of a head from segmented volumes against those of the same head from smooth ones.
#include <cstdio>
#include <vector>

#include "implicit_head.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/precompute.h"
#include "line_scores.h"
#include "truth_tables.h"

namespace benchmarks {
namespace {

using namespace laplacian_lines;

// From the head, in D: in front, from one side, and between them.
const Eigen::Vector3d kEyes[] = {{0, 0.3, 1.5}, {1.2, 0.3, 1.2}, {-1.35, -0.3, 0.15}};

/// All kinds that the style shows, and Laplacian lines alone.
struct Drawing {
    CurvePoints all, laplacian;
};

/// One from each eye.
std::vector<Drawing> draw(const TriangleMesh& mesh, const Field& field, double step,
                          const TruthOptions& options) {
    const LineExtractor extractor(mesh, field);
    LineKindSet laplacian;
    laplacian[LineKind::Laplacian] = true;
    ExtractionScratch scratch;
    LineSet lines;
    std::vector<Drawing> drawings;
    for (const Eigen::Vector3d& eye : kEyes) {
        extractor.extract(View::perspective(field.scale.diagonal * eye), options.style, scratch,
                          lines);
        const auto points = [&](LineKindSet kinds) {
            return drawn_points(lines, kinds, options.least_opacity, step);
        };
        drawings.push_back({points(options.style.shows), points(laplacian)});
    }
    return drawings;
}

Score compare_all(const std::vector<Drawing>& drawings, const std::vector<Drawing>& right,
                  CurvePoints Drawing::*kinds, double reach) {
    Score score;
    for (std::size_t i = 0; i < right.size(); ++i)
        score += compare(drawings[i].*kinds, right[i].*kinds, reach);
    return score;
}

void print_score(const Score& score) {
    std::printf(" %.2f | %.2f | %.2f |", score.recall.value(), score.precision.value(), score.f1());
}

void print_head(int voxels, const TruthOptions& options) {
    const TriangleMesh smooth = test_meshes::smooth_head(voxels),
                       terraced = test_meshes::terraced_head(voxels);
    const double diagonal = measure_scale(smooth).diagonal;
    const double step = options.drawing_reach / 800 * diagonal;
    // What the truth is does not depend on how the field of the terraces is computed.
    const std::vector<Drawing> right = draw(smooth, precompute(smooth), step, options);
    const Field field = precompute(terraced, options.field_options(diagonal));
    const std::vector<Drawing> drawings = draw(terraced, field, step, options);
    for (const double reach : {options.drawing_reach, options.reach}) {
        std::printf("| %d | %zu | %.2f | %.2f | %g %% |", voxels, terraced.triangles.size(),
                    field.report.roughness, field.scale.normal_sigma / field.scale.mean_edge,
                    reach);
        print_score(compare_all(drawings, right, &Drawing::all, reach / 100 * diagonal));
        print_score(compare_all(drawings, right, &Drawing::laplacian, reach / 100 * diagonal));
        std::printf("\n");
    }
    std::fflush(stdout);
}

}  // namespace

void print_terraces(const TruthOptions& options) {
    std::printf(
        "\nA head from volumes of labels\n\n| voxels along an axis | triangles | roughness | "
        "smoothing, mean edges | within | all kinds: recall | precision | F1 | Laplacian lines: "
        "recall | precision | F1 |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const double voxels : options.voxels)
        print_head(int(voxels), options);
}

}  // namespace benchmarks
