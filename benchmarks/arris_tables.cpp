// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of stones and parts against their arrises.
#include <cstdio>
#include <string>

#include "arris_forms.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/precompute.h"
#include "machined_part.h"
#include "mesh_noise.h"
#include "truth_tables.h"

namespace benchmarks {
namespace {

using namespace laplacian_lines;

/// By ridges alone, of convex arrises, and by all kinds that are asked for, of all arrises.
struct Scores {
    Score ridges, all;

    Scores& operator+=(const Scores& other) {
        ridges += other.ridges;
        all += other.all;
        return *this;
    }
};

LineKindSet kinds_of(std::initializer_list<LineKind> wanted) {
    LineKindSet kinds;
    for (const LineKind kind : wanted)
        kinds[kind] = true;
    return kinds;
}

/// From all eyes together; contours are left out, and with them what they do to lines beside them.
Scores measure(const TriangleMesh& mesh, const Truth& truth, double diagonal,
               const TruthOptions& options) {
    const LineExtractor extractor(mesh, precompute(mesh, options.field_options(diagonal)));
    LineStyle style = options.style;
    style.shows = options.kinds;
    const LineKindSet ridges = kinds_of({LineKind::Ridge});
    style.shows[LineKind::Ridge] = true;
    const Matching matching = {options.reach / 100 * diagonal, options.least_opacity};
    const Truth convex = truth.convex();
    ExtractionScratch scratch;
    LineSet lines;
    Scores scores;
    for (const Eigen::Vector3d& eye : arris_eyes) {
        extractor.extract(View::orthographic(eye), style, scratch, lines);
        scores.ridges += score(lines, convex.facing(eye), ridges, ridges, matching);
        scores.all += score(lines, truth.facing(eye), options.kinds,
                            kinds_of({LineKind::Ridge, LineKind::Crease}), matching);
    }
    return scores;
}

std::string in_short(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

std::string two_digits(double value) {
    char text[16];
    std::snprintf(text, sizeof text, "%.2f", value);
    return text;
}

/// The cells of a row.
std::string in_words(const Score& score) {
    const bool has_lines = score.precision.all > 0;
    return " " + two_digits(score.recall.value()) + " | " +
           (has_lines ? two_digits(score.precision.value()) : "–") + " | " +
           two_digits(score.f1()) + " |";
}

void print_head(const char* title, const char* edges) {
    std::printf("\n%s\n\n| %s | triangles x | noise | ridges: recall | precision | F1 |", title,
                edges);
    std::printf(
        " all kinds: recall | precision of edges | F1 |\n|---|---|---|---|---|---|---|---|---|\n");
}

void print_row(const std::string& edges, const std::string& resolution, double noise,
               const Scores& scores) {
    std::printf("| %s | %s | %g %% |%s%s\n", edges.c_str(), resolution.c_str(), noise,
                in_words(scores.ridges).c_str(), in_words(scores.all).c_str());
    std::fflush(stdout);
}

/// Scores of all forms together, a row for each resolution and noise.
void print_rows(double radius, const std::vector<ArrisForm>& forms, const TruthOptions& options) {
    for (const double resolution : options.resolutions) {
        std::vector<Scores> sums(options.noise.size());
        for (const ArrisForm& form : forms) {
            const TriangleMesh mesh = form.mesh(resolution);
            for (std::size_t i = 0; i < sums.size(); ++i)
                sums[i] += measure(mesh_noise::with_noise(mesh, options.noise[i] / 100), form.truth,
                                   form.diagonal, options);
        }
        for (std::size_t i = 0; i < sums.size(); ++i)
            print_row(in_short(radius) + " %", in_short(resolution), options.noise[i], sums[i]);
    }
}

}  // namespace

void print_stones(const TruthOptions& options) {
    print_head("Flaked stones", "radius of arrises");
    for (const double radius : options.radii)
        print_rows(radius, flaked_stones(radius, options), options);
}

void print_parts(const TruthOptions& options) {
    print_head("Machined parts", "radius of fillets");
    for (const double radius : options.radii)
        print_rows(radius, {machined_part(radius, options)}, options);
    const ArrisForm sharp = machined_part(0, options);
    print_row("none, 180 triangles", "–", 0,
              measure(test_meshes::sharp_part(), sharp.truth, sharp.diagonal, options));
}

}  // namespace benchmarks
