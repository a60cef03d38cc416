// SPDX-License-Identifier: GPL-3.0-or-later
// ./bench: times of redraws in the default style, beside plain ways to draw less. Files are those
// of read_mesh().
#include <thread>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "field_work.h"
#include "laplacian_lines/field_columns.h"
#include "laplacian_lines/precompute.h"
#include "laplacian_lines/threads.h"
#include "mesh_file.h"
#include "midpoint_subdivision.h"
#include "program.h"
#include "redraws.h"
#include "report.h"

namespace {

using namespace benchmarks;
using namespace laplacian_lines;

const Section kSize{"size", "Size"};
const Section kBuilding{"building_s", "Once a mesh, s"};
const Section kMemory{"memory", "Memory, bytes a vertex"};
const Section kExtraction{"extraction_ms", "A redraw, ms"};
const Section kMedians{"extraction_median_ms", nullptr};
const Section kRatios{"ratios", "Ratios"};
const Section kCounts{"counts", nullptr};
const Section kGrowth{"growth", "x in time ∝ triangles^x, from a quarter of the triangles"};

constexpr std::size_t kLargestForRounds = 1'000'000;  // triangles; of larger ones once is enough

struct Ratio {
    const char *key, *text, *a, *b;
};
constexpr Ratio kAllRatios[] = {
    {"lines_to_contours", "Laplacian lines and contours : plain contours", "lines",
     "plain_contours"},
    {"lines_to_reading", "... : reading the plain mesh", "lines", "read_plain_mesh"},
    {"lines_to_reading_extractor", "... : reading what the extractor holds", "lines",
     "read_extractor"},
    {"one_to_two_threads", "one thread : two threads", "lines", "lines_two_threads"},
    {"avx2_to_avx512", "AVX2 : AVX-512", "lines_avx2", "lines"},
    {"baseline_to_best", "baseline x86-64 : the best instruction set", "lines_baseline", "lines"},
};

struct Arguments {
    bool precompute = false, only_precompute = false;
    int first_level = 0, last_level = 0;  ///< subdivisions of the last mesh
    Turns turns;
    std::string json;
};

/// "N", or "L-N".
void set_levels(const std::string& text, Arguments& arguments) {
    const std::vector<std::string> levels = split(text, '-');
    const auto level = [&](std::size_t i) { return int(parse_number(levels[i])); };
    arguments.last_level = level(levels.size() - 1);
    arguments.first_level = levels.size() > 1 ? level(0) : 0;
    if (levels.size() > 2 || arguments.first_level < 0 ||
        arguments.last_level < arguments.first_level)
        throw std::invalid_argument("--subdivide needs N or L-N");
}

std::vector<Option> options_of(Arguments& a) {
    return {flag("--precompute", "also what is computed once", a.precompute),
            flag("--no-redraws", "only that", a.only_precompute),
            {"--subdivide [L-]N",
             "the last mesh also subdivided L (1) to N times; it is left out if L is given",
             [&a](const std::string& text) { set_levels(text, a); }},
            number("--rounds N", "of a mesh at most (20)", a.turns.most_rounds, 1),
            number("--seconds S", "for the rounds of a mesh, about (20)", a.turns.budget),
            text("--json FILE", "all figures", a.json)};
}

/// On one thread and on two, alternating.
template <class Work>
void time_alternately(const TriangleMesh& mesh, const std::string& text, const std::string& key,
                      Work work, MeshFigures& figures) {
    std::vector<Contender> contenders;
    for (const int threads : {1, 2})
        if (threads <= int(std::thread::hardware_concurrency()))
            contenders.push_back({key + (threads > 1 ? "_two_threads" : ""),
                                  text + (threads > 1 ? ", two threads" : ", one thread"),
                                  [&work, threads](std::size_t) {
                                      set_thread_limit(threads);
                                      work();
                                  }});
    take_turns(contenders, {1, mesh.triangles.size() > kLargestForRounds ? 1 : 3, 5, 4});
    set_thread_limit(0);
    for (const Contender& c : contenders)
        figures.add(kBuilding, c.key, c.text, c.best());
}

/// `kernel_size` is √h.
void add_precompute(const TriangleMesh& mesh, double kernel_size, MeshFigures& figures) {
    PrecomputeOptions options;
    options.kernel_size = kernel_size;
    Field field;
    double peak = 0;
    const auto compute = [&] {
        field = Field();  // or two would be in memory at the end
        const PeakMemory memory;
        field = precompute(mesh, options);
        peak = std::max(peak, memory.bytes());
    };
    time_alternately(mesh, "the whole field", "field", compute, figures);
    const LaplacianAlone laplacian(mesh);
    const auto sum = [&] { laplacian.compute(kernel_size / field.scale.mean_edge); };
    time_alternately(mesh, "Δn alone", "laplacian", sum, figures);
    figures.add(kMemory, "precompute_peak", "precompute at its peak, above the mesh",
                peak / double(mesh.positions.size()));
}

void add_ratios(MeshFigures& figures) {
    for (const Ratio& r : kAllRatios) {
        const double a = figures.value(kExtraction, r.a), b = figures.value(kExtraction, r.b);
        if (a > 0 && b > 0) figures.add(kRatios, r.key, r.text, a / b);
    }
}

/// Redraws, plain ways to draw less, and the extractor's time to build and its size.
void add_extraction(const TriangleMesh& mesh, const Field& field, Turns turns,
                    MeshFigures& figures) {
    Redraws redraws(mesh, field);
    redraws.check_zeros();
    figures.add(kBuilding, "extractor", "building the extractor, all threads",
                redraws.extractor_seconds());
    figures.add(kMemory, "extractor", "extractor",
                double(redraws.extractor().memory()) / double(mesh.positions.size()));
    std::size_t field_bytes = 0;
    for (const FieldColumn& column : present_columns(field))
        field_bytes += std::size_t(column.floats) * sizeof(float);
    figures.add(kMemory, "field", "field", double(field_bytes));
    std::vector<Contender> contenders = redraws.fast();
    for (const auto& more : {redraws.plain(), redraws.reading()})
        contenders.insert(contenders.end(), more.begin(), more.end());
    for (const Contender& c : contenders)
        c.run(0);  // allocates, and finds what is found once
    turns.cases = redraws.view_count();
    turns.least_rounds = std::min(turns.least_rounds, turns.most_rounds);
    figures.add(kCounts, "rounds", "rounds", take_turns(contenders, turns));
    for (const Contender& c : contenders) {
        figures.add(kExtraction, c.key, c.text, 1e3 * c.best());
        figures.add(kMedians, c.key, c.text, 1e3 * c.median());
    }
    add_ratios(figures);
    const LineSet& lines = redraws.lines(0);
    figures.add(kCounts, "lines", "lines at the first eye", double(lines.lines.size()));
    figures.add(kCounts, "segments", "segments at the first eye", double(lines.segment_count()));
}

MeshFigures measure(const std::string& name, const TriangleMesh& mesh, const Field& field,
                    const Arguments& arguments) {
    std::fprintf(stderr, "measuring %s\n", name.c_str());
    MeshFigures figures{name};
    figures.add(kSize, "triangles", "triangles", double(mesh.triangles.size()));
    figures.add(kSize, "vertices", "vertices", double(mesh.positions.size()));
    figures.add(kSize, "kernel_in_mean_edges", "√h in mean edges",
                field.scale.kernel_size / field.scale.mean_edge);
    if (arguments.precompute || arguments.only_precompute)
        add_precompute(mesh, field.scale.kernel_size, figures);
    if (!arguments.only_precompute) add_extraction(mesh, field, arguments.turns, figures);
    return figures;
}

/// Exponents of growth to a mesh with four times the triangles.
void add_growth(const MeshFigures& coarse, MeshFigures& fine) {
    for (const auto& [key, text] : {std::pair{"lines", "Laplacian lines and contours"},
                                    {"plain_contours", "plain contours"}}) {
        const double before = coarse.value(kExtraction, key), now = fine.value(kExtraction, key);
        if (before > 0 && now > 0)
            fine.add(kGrowth, key, text, std::log(now / before) / std::log(4.0));
    }
}

/// At all levels of subdivision.
void measure_levels(const std::string& file, int first, int last, const Arguments& arguments,
                    std::vector<MeshFigures>& meshes) {
    TriangleMesh mesh = test_meshes::read_mesh(file);
    Field field = precompute(mesh);
    for (int level = 0; level <= last; ++level) {
        if (level > 0) {
            test_meshes::subdivide(mesh, field);
            // precompute() undoes what is cut in the very middles
            mesh.positions.back() += 1e-4 * (mesh.positions.front() - mesh.positions.back());
        }
        if (level < first) continue;
        const std::string suffix = level > 0 ? " × " + std::to_string(1 << 2 * level) : "";
        meshes.push_back(measure(test_meshes::mesh_name(file) + suffix, mesh, field, arguments));
        if (level > first) add_growth(meshes[meshes.size() - 2], meshes.back());
    }
}

}  // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    return run_program(argc, argv, "MESH...", options_of(arguments), [&](const auto& files) {
        std::vector<MeshFigures> meshes;
        for (const std::string& file : files) {
            const bool last = &file == &files.back();
            measure_levels(file, last ? arguments.first_level : 0, last ? arguments.last_level : 0,
                           arguments, meshes);
        }
        print_report(meshes, arguments.json);
        return true;
    });
}
