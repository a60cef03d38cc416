// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of stones and parts against their arrises.
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>

#include "flaked_stone.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/line_mixture.h"
#include "laplacian_lines/precompute.h"
#include "line_scores.h"
#include "machined_part.h"
#include "mesh_noise.h"
#include "truth_options.h"

namespace benchmarks {
namespace {

using namespace laplacian_lines;

constexpr int kStoneLevel = 5;       // of resolution 1: 20,480 triangles
constexpr double kPartEdge = 0.012;  // of resolution 1, in D
// All around a form.
const Eigen::Vector3d kEyes[] = {{1, 0.2, 0.3},  {-1, 0.3, 0.2},  {0.3, 1, 0.2},
                                 {0.2, -1, 0.3}, {0.2, 0.3, 1.0}, {0.3, 0.2, -1}};

/// A form whose arrises are known.
struct ArrisForm {
    Truth truth;
    double diagonal;
    /// Of so many times the triangles of resolution 1.
    std::function<TriangleMesh(double resolution)> mesh;
};

/// One per seed; `radius` of their arrises, % of D.
std::vector<ArrisForm> flaked_stones(double radius, const TruthOptions& options) {
    std::vector<ArrisForm> forms;
    for (const double seed : options.seeds) {
        const auto stone = std::make_shared<const test_meshes::FlakedStone>(
            test_meshes::StoneShape{unsigned(seed), radius / 100, 40, options.ripple_angle});
        forms.push_back({Truth(find_arrises(*stone, options.blunt_angle), options.sharp_angle,
                               options.blunt_angle),
                         stone->diagonal(), [stone](double resolution) {
                             const int doublings = int(std::lround(std::log2(resolution) / 2));
                             return stone->mesh(kStoneLevel + doublings);
                         }});
    }
    return forms;
}

/// With fillets of this radius, % of D.
ArrisForm machined_part(double radius, const TruthOptions& options) {
    const auto part = std::make_shared<const test_meshes::MachinedPart>(radius / 100);
    return {Truth(part->arrises(), options.sharp_angle, options.blunt_angle),
            test_meshes::MachinedPart::diagonal(),
            [part](double resolution) { return part->mesh(kPartEdge / std::sqrt(resolution)); }};
}

/// Ridges against convex arrises, and all wanted kinds against all arrises.
struct Scores {
    Score ridges, all;

    Scores& operator+=(const Scores& other) {
        ridges += other.ridges;
        all += other.all;
        return *this;
    }
};

/// From all eyes together, without contours and their effect on lines beside them.
Scores measure(const TriangleMesh& mesh, const Truth& truth, double diagonal,
               const TruthOptions& options) {
    const LineExtractor extractor(mesh, precompute(mesh, options.field_options(diagonal)));
    LineStyle style = options.style;
    style.shows = options.kinds;
    const LineKindSet ridges = only_kinds({LineKind::Ridge});
    style.shows[LineKind::Ridge] = true;
    const Matching matching = {options.reach / 100 * diagonal, options.least_opacity};
    const Truth convex = truth.convex();
    ExtractionScratch scratch;
    LineSet lines;
    Scores scores;
    for (const Eigen::Vector3d& eye : kEyes) {
        extractor.extract(View::orthographic(eye), style, scratch, lines);
        scores.ridges += score(lines, convex.facing(eye), ridges, ridges, matching);
        scores.all += score(lines, truth.facing(eye), options.kinds,
                            only_kinds({LineKind::Ridge, LineKind::Crease}), matching);
    }
    return scores;
}

std::string text_of(const char* format, double value) {
    char text[32];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string in_words(const Score& score) {
    const bool has_lines = score.precision.all > 0;
    return " " + text_of("%.2f", score.recall.value()) + " | " +
           (has_lines ? text_of("%.2f", score.precision.value()) : "–") + " | " +
           text_of("%.2f", score.f1()) + " |";
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

/// A row for each resolution and noise, over all forms.
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
            print_row(text_of("%g", radius) + " %", text_of("%g", resolution), options.noise[i],
                      sums[i]);
    }
}

}  // namespace

void print_stones(const TruthOptions& options, const std::vector<std::string>&) {
    print_head("Flaked stones", "radius of arrises");
    for (const double radius : options.radii)
        print_rows(radius, flaked_stones(radius, options), options);
}

void print_parts(const TruthOptions& options, const std::vector<std::string>&) {
    print_head("Machined parts", "radius of fillets");
    for (const double radius : options.radii)
        print_rows(radius, {machined_part(radius, options)}, options);
    const ArrisForm sharp = machined_part(0, options);
    print_row("none, 180 triangles", "–", 0,
              measure(test_meshes::sharp_part(), sharp.truth, sharp.diagonal, options));
}

}  // namespace benchmarks
