// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings of meshes with noise or terraces against those of the same forms without.
#include <Eigen/Geometry>
#include <cstdio>
#include <deque>

#include "implicit_head.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/line_mixture.h"
#include "laplacian_lines/precompute.h"
#include "line_scores.h"
#include "mesh_file.h"
#include "mesh_noise.h"
#include "registry.h"
#include "truth_options.h"

namespace benchmarks {
namespace {

using namespace laplacian_lines;

/// Kinds drawn together, and those that count.
struct Kinds {
    std::string name;
    LineKindSet drawn, counted;
};

/// One mesh from some eyes.
class Drawings {
public:
    Drawings(const TriangleMesh& mesh, const std::vector<View>& views, double diagonal,
             const PrecomputeOptions& field, const TruthOptions& options)
        : views_(views),
          options_(options),
          step_(options.drawing_reach / 800 * diagonal),
          field_(precompute(mesh, field)),
          extractor_(mesh, field_) {}

    const Field& field() const { return field_; }

    CurvePoints from(std::size_t view, const Kinds& kinds) {
        LineStyle style = options_.style;
        style.shows = kinds.drawn;
        extractor_.extract(views_[view], style, scratch_, lines_);
        return drawn_points(lines_, kinds.counted, options_.least_opacity, step_);
    }

    /// From all eyes together.
    Score against(Drawings& right, const Kinds& kinds, double reach) {
        Score score;
        for (std::size_t view = 0; view < views_.size(); ++view)
            score += compare(from(view, kinds), right.from(view, kinds), reach);
        return score;
    }

private:
    const std::vector<View> views_;
    const TruthOptions& options_;
    const double step_;
    const Field field_;
    const LineExtractor extractor_;
    ExtractionScratch scratch_;
    LineSet lines_;
};

/// From the front, a little from above.
View front_view(const TriangleMesh& mesh, double diagonal) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : mesh.positions)
        if (p.allFinite() && p.norm() < 1e4 * diagonal) box.extend(p);
    return View::perspective(box.center() + 1.5 * diagonal * Eigen::Vector3d(0, 0.2, 1));
}

void print_score(const Score& score) {
    if (score.is_empty())
        std::printf(" – |");
    else
        std::printf(" %.2f / %.2f / %.2f |", score.f1(), score.recall.value(),
                    score.precision.value());
    std::fflush(stdout);
}

void print_noise_head(const char* title, const TruthOptions& options) {
    std::printf("\n%s\n\n| mesh | triangles | lines | their length, D |", title);
    for (const double noise : options.drawing_noise)
        std::printf(" F1 / recall / precision at %g %% |", noise);
    std::printf("\n|---|---|---|---|");
    for (std::size_t i = 0; i < options.drawing_noise.size(); ++i)
        std::printf("---|");
    std::printf("\n");
}

void print_noise_rows(const std::string& name, const TriangleMesh& mesh,
                      const std::vector<Kinds>& rows, const TruthOptions& options) {
    const double diagonal = measure_scale(mesh).diagonal;
    const std::vector<View> views = {front_view(mesh, diagonal)};
    PrecomputeOptions field = options.field_options(diagonal);
    for (const Kinds& kinds : rows)
        field.curvature_derivatives |= kinds.drawn.needs_derivatives();
    Drawings clean(mesh, views, diagonal, field, options);
    std::deque<std::deque<Drawings>> noisy;  // by noise, then by seed
    for (const double noise : options.drawing_noise) {
        noisy.emplace_back();
        for (const double seed : options.drawing_seeds)
            noisy.back().emplace_back(mesh_noise::with_noise(mesh, noise / 100, unsigned(seed)),
                                      views, diagonal, field, options);
    }
    for (const Kinds& kinds : rows) {
        double length = 0;
        for (const double part : clean.from(0, kinds).lengths)
            length += part / diagonal;
        std::printf("| %s | %zu | %s | %.2f |", name.c_str(), mesh.triangles.size(),
                    kinds.name.c_str(), length);
        for (auto& of_noise : noisy) {
            Score score;
            for (Drawings& drawings : of_noise)
                score += drawings.against(clean, kinds, options.drawing_reach / 100 * diagonal);
            print_score(score);
        }
        std::printf("\n");
    }
}

Kinds default_kinds(const TruthOptions& options) {
    return {"all", options.style.shows, options.style.shows};
}

void print_head(int voxels, const TruthOptions& options) {
    const TriangleMesh smooth = test_meshes::smooth_head(voxels),
                       terraced = test_meshes::terraced_head(voxels);
    const double diagonal = measure_scale(smooth).diagonal;
    std::vector<View> views;  // in front, from one side, and between them
    for (const Eigen::Vector3d& eye :
         {Eigen::Vector3d(0, 0.3, 1.5), {1.2, 0.3, 1.2}, {-1.35, -0.3, 0.15}})
        views.push_back(View::perspective(diagonal * eye));
    // The truth does not depend on how the field of the terraces is computed.
    Drawings right(smooth, views, diagonal, {}, options);
    Drawings drawings(terraced, views, diagonal, options.field_options(diagonal), options);
    const Field& field = drawings.field();
    const Kinds all = default_kinds(options);
    for (const double reach : {options.drawing_reach, options.reach}) {
        std::printf("| %d | %zu | %.2f | %.2f | %g %% |", voxels, terraced.triangles.size(),
                    field.report.roughness, field.scale.normal_sigma / field.scale.mean_edge,
                    reach);
        for (const Kinds& kinds : {all, {"", all.drawn, only_kinds({LineKind::Laplacian})}})
            print_score(drawings.against(right, kinds, reach / 100 * diagonal));
        std::printf("\n");
    }
}

}  // namespace

const std::array<TruthTable, 6>& truth_tables() {
    static const std::array<TruthTable, 6> tables = {{{"stones", print_stones},
                                                      {"parts", print_parts},
                                                      {"drawings", print_drawings},
                                                      {"kinds", print_kinds_alone},
                                                      {"terraces", print_terraces},
                                                      {"motion", print_motion}}};
    return tables;
}

void print_drawings(const TruthOptions& options, const std::vector<std::string>& files) {
    print_noise_head("Drawings of noisy meshes", options);
    const std::vector<Kinds> rows = {default_kinds(options)};
    for (const test_meshes::MeshEntry& entry : test_meshes::all_entries())
        print_noise_rows(entry.name, entry.get().mesh, rows, options);
    for (const std::string& file : files)
        print_noise_rows(test_meshes::mesh_name(file), test_meshes::read_mesh(file), rows, options);
}

void print_kinds_alone(const TruthOptions& options, const std::vector<std::string>& files) {
    if (files.empty()) return;
    print_noise_head("Each kind of lines of noisy meshes", options);
    std::vector<Kinds> rows;
    for (const LineKindDescription& row : line_kinds)
        rows.push_back({row.many, only_kinds({row.kind}), only_kinds({row.kind})});
    for (const std::string& file : files)
        print_noise_rows(test_meshes::mesh_name(file), test_meshes::read_mesh(file), rows, options);
}

void print_terraces(const TruthOptions& options, const std::vector<std::string>&) {
    std::printf(
        "\nA head from volumes of labels\n\n| voxels along an axis | triangles | roughness | "
        "smoothing, mean edges | within | all kinds: F1 / recall / precision | Laplacian lines |\n"
        "|---|---|---|---|---|---|---|\n");
    for (const double voxels : options.voxels)
        print_head(int(voxels), options);
}

}  // namespace benchmarks
