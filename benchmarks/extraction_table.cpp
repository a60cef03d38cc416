// SPDX-License-Identifier: GPL-3.0-or-later
// extraction_table [--subdivide N] [--rounds N] MESH...
// Times of an orbit of 24 eyes at 1.25 D, in the default style, beside plain ways to draw less.
// All of them take turns at each eye; a time is the mean over the eyes of the best of all rounds.
// Files are OBJ or PLY, plain or with .gz. The last mesh is also subdivided N times.
#include <omp.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <string>

#include "cluster_kernels.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/precompute.h"
#include "mesh_file.h"
#include "midpoint_subdivision.h"
#include "naive_lines.h"
#include "naive_tracing.h"
#include "orbit.h"

namespace {

using namespace laplacian_lines;

constexpr std::size_t kLargestForHashing = 4'000'000;  // triangles

struct Contender {
    std::string name;
    std::function<void(const View&)> run;
    std::vector<double> best = std::vector<double>(kEyes, std::numeric_limits<double>::max());

    double milliseconds() const {
        return 1e3 * std::accumulate(best.begin(), best.end(), 0.0) / kEyes;
    }
};

double seconds(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// All times of one mesh.
class Table {
public:
    Table(const std::string& name, const TriangleMesh& mesh, const Field& field, int rounds)
        : mesh_(mesh), views_(orbit(mesh)), contours_(mesh, field.normals) {
        const double building =
            seconds([&] { extractor_ = std::make_unique<LineExtractor>(mesh, field); });
        std::printf("%s: %zu triangles, extractor of %.0f bytes a vertex built in %.2f s\n",
                    name.c_str(), mesh.triangles.size(),
                    double(extractor_->memory()) / double(mesh.positions.size()), building);
        floor_.assign(2 * mesh.positions.size() + 3 * mesh.triangles.size() / 2, 1);
        add_contenders(field);
        for (int round = 0; round < rounds; ++round)
            for (std::size_t i = 0; i < views_.size(); ++i)
                for (Contender& c : contenders_)
                    c.best[i] = std::min(c.best[i], seconds([&] { c.run(views_[i]); }));
        print();
    }

private:
    void add_extraction(const char* name, InstructionSet set, int threads) {
        if (!use_instruction_set(set) || omp_get_num_procs() < threads) return;
        contenders_.push_back({name, [this, set, threads](const View& view) {
                                   use_instruction_set(set);
                                   omp_set_num_threads(threads);
                                   extractor_->extract(view, style_, scratch_, lines_);
                               }});
    }

    void add_contenders(const Field& field) {
        style_.ridges = style_.borders = false;  // these do not depend on the view
        add_extraction("Laplacian lines and contours, AVX-512", InstructionSet::Avx512, 1);
        add_extraction("  the same on two threads", InstructionSet::Avx512, 2);
        add_extraction("  the same with AVX2", InstructionSet::Avx2, 1);
        add_extraction("  the same for baseline x86-64", InstructionSet::Baseline, 1);
        contenders_.push_back({"plain contours, not traced",
                               [this](const View& view) { contours_.extract(view, points_); }});
        if (mesh_.triangles.size() <= kLargestForHashing) {
            hashed_ = std::make_unique<benchmarks::NaiveTracing>(mesh_, field.laplacian_normals);
            contenders_.push_back(
                {"plain Laplacian lines, traced by a hash map",
                 [this](const View& view) { hashed_->extract(view, points_, starts_); }});
        }
        contenders_.push_back({"reading 16 bytes a vertex, 12 a triangle", [this](const View&) {
                                   sum_ += std::accumulate(floor_.begin(), floor_.end(), 0ul);
                               }});
    }

    void print() {
        const auto contours = std::find_if(
            contenders_.begin(), contenders_.end(),
            [](const Contender& c) { return c.name.find("contours, not") != c.name.npos; });
        for (const Contender& c : contenders_)
            std::printf("  %-45s %8.3f ms  %6.2f x plain contours\n", c.name.c_str(),
                        c.milliseconds(), c.milliseconds() / contours->milliseconds());
        extractor_->extract(views_[0], style_, scratch_, lines_);
        std::printf("  %zu segments in %zu lines at the first eye\n", lines_.segment_count(),
                    lines_.lines.size());
        std::fflush(stdout);
    }

    const TriangleMesh& mesh_;
    const std::vector<View> views_;
    LineStyle style_;
    std::unique_ptr<LineExtractor> extractor_;
    benchmarks::NaiveLines contours_;
    std::unique_ptr<benchmarks::NaiveTracing> hashed_;
    std::vector<std::uint64_t> floor_;
    volatile std::uint64_t sum_ = 0;
    ExtractionScratch scratch_;
    LineSet lines_;
    std::vector<Eigen::Vector3f> points_;
    std::vector<std::uint32_t> starts_;
    std::vector<Contender> contenders_;
};

}  // namespace

int main(int argc, char** argv) {
    int subdivisions = 0, rounds = 20;
    std::vector<std::string> files;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        if (argument == "--subdivide" && i + 1 < argc)
            subdivisions = std::atoi(argv[++i]);
        else if (argument == "--rounds" && i + 1 < argc)
            rounds = std::max(1, std::atoi(argv[++i]));
        else
            files.push_back(argument);
    }
    if (files.empty()) {
        std::fprintf(stderr, "extraction_table [--subdivide N] [--rounds N] MESH...\n");
        return 2;
    }
    try {
        for (const std::string& file : files) {
            TriangleMesh mesh = test_meshes::read_mesh(file);
            Field field = precompute(mesh);
            const std::string name = file.substr(file.find_last_of('/') + 1);
            Table(name, mesh, field, rounds);
            if (file != files.back()) continue;
            for (int level = 1; level <= subdivisions; ++level) {
                benchmarks::subdivide(mesh, field);
                Table(name + " subdivided " + std::to_string(level) + " times", mesh, field,
                      std::max(1, rounds >> level));
            }
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
