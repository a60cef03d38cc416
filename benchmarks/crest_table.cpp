// SPDX-License-Identifier: GPL-3.0-or-later
// Ridges and valleys beside crest lines as they are usually defined: as many as are as long as ours
// on the mesh without noise, and those of given strengths.
#include <cstdio>
#include <string>
#include <vector>

#include "arris_forms.h"
#include "crest_lines.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/precompute.h"
#include "mesh_file.h"
#include "mesh_noise.h"
#include "truth_tables.h"

namespace benchmarks {
namespace {

using namespace laplacian_lines;

constexpr LineKind kKinds[] = {LineKind::Ridge, LineKind::Valley};

LineKindSet only(LineKind kind) {
    LineKindSet kinds;
    kinds[kind] = true;
    return kinds;
}

/// Drawings of one kind of a mesh: ours first, then those compared with it.
using Drawings = std::vector<LineSet>;

/// What both ways find in a mesh.
class Crests {
public:
    Crests(const TriangleMesh& mesh, double diagonal, const TruthOptions& options) {
        PrecomputeOptions with_derivatives = options.field_options(diagonal);
        with_derivatives.curvature_derivatives = true;
        const Field field = precompute(mesh, with_derivatives);
        const LineExtractor extractor(mesh, field);
        ExtractionScratch scratch;
        LineStyle style = options.style;
        for (const LineKind kind : kKinds) {
            style.shows = only(kind);  // without contours they are the same from everywhere
            extractor.extract(View::orthographic(arris_eyes[0]), style, scratch, ours(kind));
            usual(kind) = crest_lines(mesh, field, kind);
        }
    }

    LineSet& ours(LineKind kind) { return ours_[kind == LineKind::Valley]; }
    LineSet& usual(LineKind kind) { return usual_[kind == LineKind::Valley]; }

    Drawings drawings(LineKind kind, const std::vector<double>& strengths) {
        Drawings drawings = {ours(kind)};
        for (const double strength : strengths)
            drawings.push_back(lines_of_strength(usual(kind), strength));
        return drawings;
    }

private:
    LineSet ours_[2], usual_[2];
};

CurvePoints points_of(const LineSet& lines, LineKind kind, double diagonal,
                      const TruthOptions& options) {
    return drawn_points(lines, only(kind), options.least_opacity,
                        options.drawing_reach / 800 * diagonal);
}

/// In D.
double length_of(const CurvePoints& curves, double diagonal) {
    double length = 0;
    for (const double part : curves.lengths)
        length += part / diagonal;
    return length;
}

/// Of what is compared with ours: that with which it is as long, and those that are asked for.
std::vector<double> strengths_of(Crests& clean, LineKind kind, double diagonal,
                                 const TruthOptions& options) {
    const double length = length_of(points_of(clean.ours(kind), kind, diagonal, options), diagonal);
    std::vector<double> strengths = {strength_for_length(clean.usual(kind), length)};
    strengths.insert(strengths.end(), options.crest_strengths.begin(),
                     options.crest_strengths.end());
    return strengths;
}

void print_head(const char* title, const std::vector<const char*>& columns,
                const TruthOptions& options) {
    std::printf("\n%s\n\n|", title);
    for (const char* column : columns)
        std::printf(" %s |", column);
    std::printf(" ours | as long |");
    for (const double strength : options.crest_strengths)
        std::printf(" strength %g |", strength);
    std::printf("\n|");
    for (std::size_t i = 0; i < columns.size() + 2 + options.crest_strengths.size(); ++i)
        std::printf("---|");
    std::printf("\n");
}

void print_score(const Score& score) {
    std::printf(" %.2f / %.2f, %.2f |", score.recall.value(), score.precision.value(), score.f1());
}

/// Of arrises, as those that face each eye; a sum over forms for each drawing.
void add_scores(const Drawings& drawings, LineKind kind, const ArrisForm& form,
                const TruthOptions& options, std::vector<Score>& sums) {
    const Truth truth = kind == LineKind::Ridge ? form.truth.convex() : form.truth.concave();
    const Matching matching = {options.reach / 100 * form.diagonal, options.least_opacity};
    sums.resize(drawings.size());
    for (std::size_t i = 0; i < drawings.size(); ++i)
        for (const Eigen::Vector3d& eye : arris_eyes)
            sums[i] += score(drawings[i], truth.facing(eye), only(kind), only(kind), matching);
}

/// Adds those of a form; `sums`: by noise and kind.
void add_form(const ArrisForm& form, double resolution, const TruthOptions& options,
              std::vector<std::vector<Score>>& sums) {
    const TriangleMesh mesh = form.mesh(resolution);
    Crests clean(mesh, form.diagonal, options);
    for (std::size_t i = 0; i < options.noise.size(); ++i) {
        Crests noisy(mesh_noise::with_noise(mesh, options.noise[i] / 100), form.diagonal, options);
        for (std::size_t k = 0; k < 2; ++k) {
            const LineKind kind = kKinds[k];
            const auto strengths = strengths_of(clean, kind, form.diagonal, options);
            add_scores(noisy.drawings(kind, strengths), kind, form, options, sums[2 * i + k]);
        }
    }
}

/// Of all forms together; stones have no concave arrises.
void print_arris_rows(const char* name, double radius, const std::vector<ArrisForm>& forms,
                      const TruthOptions& options) {
    for (const double resolution : options.resolutions) {
        std::vector<std::vector<Score>> sums(2 * options.noise.size());
        for (const ArrisForm& form : forms)
            add_form(form, resolution, options, sums);
        for (std::size_t i = 0; i < sums.size(); ++i) {
            if (sums[i].empty() || sums[i][0].recall.all == 0) continue;
            std::printf("| %s | %g %% | %g | %g %% | %s |", name, radius, resolution,
                        options.noise[i / 2], describe(kKinds[i % 2]).many);
            for (const Score& sum : sums[i])
                print_score(sum);
            std::printf("\n");
        }
        std::fflush(stdout);
    }
}

/// The lengths of the drawings of a mesh without noise, of which it returns the points.
std::vector<CurvePoints> print_lengths(const Drawings& drawings, LineKind kind, double diagonal,
                                       const TruthOptions& options) {
    std::vector<CurvePoints> points;
    for (const LineSet& drawing : drawings) {
        points.push_back(points_of(drawing, kind, diagonal, options));
        std::printf(" %.2f |", length_of(points.back(), diagonal));
    }
    std::printf("\n");
    return points;
}

/// Of noisy drawings against the clean one of the same way.
void print_drawing_rows(const std::string& name, const TriangleMesh& mesh,
                        const TruthOptions& options) {
    const double diagonal = measure_scale(mesh).diagonal;
    Crests clean(mesh, diagonal, options);
    for (const LineKind kind : kKinds) {
        const std::vector<double> strengths = strengths_of(clean, kind, diagonal, options);
        std::printf("| %s | %s | length, D; as long: strength %.3g |", name.c_str(),
                    describe(kind).many, strengths[0]);
        const auto right = print_lengths(clean.drawings(kind, strengths), kind, diagonal, options);
        for (const double noise : options.drawing_noise) {
            Crests noisy(mesh_noise::with_noise(mesh, noise / 100), diagonal, options);
            std::printf("| %s | %s | noise %g %% |", name.c_str(), describe(kind).many, noise);
            const Drawings drawings = noisy.drawings(kind, strengths);
            for (std::size_t i = 0; i < drawings.size(); ++i)
                print_score(compare(points_of(drawings[i], kind, diagonal, options), right[i],
                                    options.drawing_reach / 100 * diagonal));
            std::printf("\n");
            std::fflush(stdout);
        }
    }
}

}  // namespace

void print_crests(const TruthOptions& options) {
    print_head("Ridges and valleys beside crest lines: recall / precision, F1",
               {"form", "radius of arrises", "triangles x", "noise", "kind"}, options);
    for (const double radius : options.radii) {
        print_arris_rows("stones", radius, flaked_stones(radius, options), options);
        print_arris_rows("part", radius, {machined_part(radius, options)}, options);
    }
    if (options.files.empty()) return;
    print_head("The same of noisy meshes", {"mesh", "kind", "what"}, options);
    for (const std::string& file : options.files)
        print_drawing_rows(test_meshes::mesh_name(file), test_meshes::read_mesh(file), options);
}

}  // namespace benchmarks
