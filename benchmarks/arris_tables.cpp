// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of stones and parts against their arrises.
#include <cmath>
#include <cstdio>
#include <string>

#include "flaked_stone.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/precompute.h"
#include "line_scores.h"
#include "machined_part.h"
#include "mesh_noise.h"
#include "truth_tables.h"

namespace benchmarks {
namespace {

using namespace laplacian_lines;

constexpr int kStoneLevel = 5;       // of resolution 1: 20,480 triangles
constexpr double kPartEdge = 0.012;  // of resolution 1, in D
const Eigen::Vector3d kEyes[] = {{1, 0.2, 0.3},  {-1, 0.3, 0.2},  {0.3, 1, 0.2},
                                 {0.2, -1, 0.3}, {0.2, 0.3, 1.0}, {0.3, 0.2, -1}};

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
    for (const Eigen::Vector3d& eye : kEyes) {
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

/// A row for each noise.
void print_rows(double radius, double resolution, const TruthOptions& options,
                const std::vector<Scores>& by_noise) {
    for (std::size_t i = 0; i < by_noise.size(); ++i)
        print_row(in_short(radius) + " %", in_short(resolution), options.noise[i], by_noise[i]);
}

int doublings(double resolution) {
    return int(std::lround(std::log2(resolution) / 2));
}

/// The scores of a mesh at each noise are added to those in `sums`.
void add_noisy(const TriangleMesh& mesh, const Truth& truth, double diagonal,
               const TruthOptions& options, std::vector<Scores>& sums) {
    sums.resize(options.noise.size());
    for (std::size_t i = 0; i < sums.size(); ++i)
        sums[i] += measure(
            options.noise[i] > 0 ? mesh_noise::with_noise(mesh, options.noise[i] / 100) : mesh,
            truth, diagonal, options);
}

struct StoneWithTruth {
    test_meshes::FlakedStone stone;
    Truth truth;

    /// `radius` in percent.
    StoneWithTruth(unsigned seed, double radius, const TruthOptions& options)
        : stone({seed, radius / 100, 40, options.ripple_angle}),
          truth(find_arrises(stone, options.blunt_angle), options.sharp_angle,
                options.blunt_angle) {}
};

}  // namespace

void print_stones(const TruthOptions& options) {
    print_head("Flaked stones", "radius of arrises");
    for (const double radius : options.radii) {
        std::vector<StoneWithTruth> stones;
        for (const double seed : options.seeds)
            stones.emplace_back(unsigned(seed), radius, options);
        for (const double resolution : options.resolutions) {
            std::vector<Scores> sums;
            for (const StoneWithTruth& of_seed : stones)
                add_noisy(of_seed.stone.mesh(kStoneLevel + doublings(resolution)), of_seed.truth,
                          of_seed.stone.diagonal(), options, sums);
            print_rows(radius, resolution, options, sums);
        }
    }
}

void print_parts(const TruthOptions& options) {
    print_head("Machined parts", "radius of fillets");
    const auto truth_of = [&](const test_meshes::MachinedPart& part) {
        return Truth(part.arrises(), options.sharp_angle, options.blunt_angle);
    };
    const double diagonal = test_meshes::MachinedPart::diagonal();
    for (const double radius : options.radii) {
        const test_meshes::MachinedPart part(radius / 100);
        for (const double resolution : options.resolutions) {
            std::vector<Scores> sums;
            add_noisy(part.mesh(kPartEdge / std::sqrt(resolution)), truth_of(part), diagonal,
                      options, sums);
            print_rows(radius, resolution, options, sums);
        }
    }
    print_row("none, 180 triangles", "–", 0,
              measure(test_meshes::sharp_part(), truth_of(test_meshes::MachinedPart(0)), diagonal,
                      options));
}

}  // namespace benchmarks
