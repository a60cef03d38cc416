// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings of noisy meshes against those of clean ones.
#include <Eigen/Geometry>
#include <cstdio>
#include <deque>
#include <string>

#include "laplacian_lines/error.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/precompute.h"
#include "line_scores.h"
#include "mesh_file.h"
#include "mesh_noise.h"
#include "registry.h"
#include "truth_tables.h"

namespace benchmarks {
namespace {

using namespace laplacian_lines;

/// In front of a mesh, a little from above.
View front_view(const TriangleMesh& mesh, double diagonal) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : mesh.positions)
        if (p.allFinite() && p.norm() < 1e4 * diagonal) box.extend(p);
    return View::perspective(box.center() + 1.5 * diagonal * Eigen::Vector3d(0, 0.2, 1));
}

/// All kinds that the style shows.
CurvePoints draw(const TriangleMesh& mesh, const View& view, double diagonal,
                 const TruthOptions& options) {
    const LineExtractor extractor(mesh, precompute(mesh, options.field_options(diagonal)));
    ExtractionScratch scratch;
    LineSet lines;
    extractor.extract(view, options.style, scratch, lines);
    return drawn_points(lines, options.style.shows, options.least_opacity,
                        options.drawing_reach / 800 * diagonal);
}

void print_mesh(const std::string& name, const TriangleMesh& mesh, const TruthOptions& options) {
    const double diagonal = measure_scale(mesh).diagonal;
    const View view = front_view(mesh, diagonal);
    const CurvePoints clean = draw(mesh, view, diagonal, options);
    double length = 0;
    for (const double part : clean.lengths)
        length += part / diagonal;
    std::printf("| %s | %zu | %.2f |", name.c_str(), mesh.triangles.size(), length);
    for (const double noise : options.drawing_noise) {
        const CurvePoints noisy =
            draw(mesh_noise::with_noise(mesh, noise / 100), view, diagonal, options);
        const Score score = compare(noisy, clean, options.drawing_reach / 100 * diagonal);
        if (score.is_empty())
            std::printf(" – |");
        else
            std::printf(" %.2f |", score.f1());
        std::fflush(stdout);
    }
    std::printf("\n");
}

/// A mesh with C, for drawings of any kind.
class Drawings {
public:
    Drawings(const TriangleMesh& mesh, const View& view, double diagonal,
             const TruthOptions& options)
        : view_(view), diagonal_(diagonal), options_(options), extractor_(mesh, field_of(mesh)) {}

    CurvePoints of(LineKind kind) {
        LineStyle style = options_.style;
        style.shows = LineKindSet();
        style.shows[kind] = true;
        extractor_.extract(view_, style, scratch_, lines_);
        return drawn_points(lines_, style.shows, options_.least_opacity,
                            options_.drawing_reach / 800 * diagonal_);
    }

private:
    Field field_of(const TriangleMesh& mesh) const {
        PrecomputeOptions field = options_.field_options(diagonal_);
        field.curvature_derivatives = true;
        return precompute(mesh, field);
    }

    const View view_;
    const double diagonal_;
    const TruthOptions& options_;
    const LineExtractor extractor_;
    ExtractionScratch scratch_;
    LineSet lines_;
};

/// Of one noise, a drawing for each seed.
using NoisyDrawings = std::deque<Drawings>;

Score score_of(NoisyDrawings& noisy, LineKind kind, const CurvePoints& right, double reach) {
    Score score;
    for (Drawings& drawing : noisy)
        score += compare(drawing.of(kind), right, reach);
    return score;
}

void print_kinds_of(const std::string& name, const TriangleMesh& mesh,
                    const TruthOptions& options) {
    const double diagonal = measure_scale(mesh).diagonal;
    const View view = front_view(mesh, diagonal);
    Drawings clean(mesh, view, diagonal, options);
    std::deque<NoisyDrawings> of_noise;
    for (const double noise : options.drawing_noise) {
        of_noise.emplace_back();
        for (const double seed : options.drawing_seeds)
            of_noise.back().emplace_back(mesh_noise::with_noise(mesh, noise / 100, unsigned(seed)),
                                         view, diagonal, options);
    }
    for (const LineKindDescription& row : line_kinds) {
        const CurvePoints right = clean.of(row.kind);
        double length = 0;
        for (const double part : right.lengths)
            length += part / diagonal;
        std::printf("| %s | %s | %.2f |", name.c_str(), row.many, length);
        for (NoisyDrawings& noisy : of_noise) {
            const Score score =
                score_of(noisy, row.kind, right, options.drawing_reach / 100 * diagonal);
            if (score.is_empty())
                std::printf(" – |");
            else
                std::printf(" %.2f / %.2f / %.2f |", score.f1(), score.recall.value(),
                            score.precision.value());
        }
        std::printf("\n");
        std::fflush(stdout);
    }
}

}  // namespace

void print_kinds_alone(const TruthOptions& options) {
    if (options.files.empty()) return;
    std::printf("\nEach kind of lines of noisy meshes\n\n| mesh | kind | length of lines, D |");
    for (const double noise : options.drawing_noise)
        std::printf(" F1 / recall / precision at %g %% |", noise);
    std::printf("\n|---|---|---|");
    for (std::size_t i = 0; i < options.drawing_noise.size(); ++i)
        std::printf("---|");
    std::printf("\n");
    for (const std::string& file : options.files)
        print_kinds_of(file.substr(file.rfind('/') + 1), test_meshes::read_mesh(file), options);
}

void print_drawings(const TruthOptions& options) {
    std::printf("\nDrawings of noisy meshes\n\n| mesh | triangles | length of lines, D |");
    for (const double noise : options.drawing_noise)
        std::printf(" F1 at %g %% |", noise);
    std::printf("\n|---|---|---|");
    for (std::size_t i = 0; i < options.drawing_noise.size(); ++i)
        std::printf("---|");
    std::printf("\n");
    for (const test_meshes::MeshEntry& entry : test_meshes::all_entries())
        print_mesh(entry.name, entry.get().mesh, options);
    for (const std::string& file : options.files)
        print_mesh(file.substr(file.rfind('/') + 1), test_meshes::read_mesh(file), options);
}

}  // namespace benchmarks
