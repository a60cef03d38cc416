// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind ./bench --paper: the table of the paper, redraws of each kind of lines against
// contours alone. Times are medians; those of one thread are processor time, which depends little
// on what else runs. What others have published stands beside it in docs/performance.md.
#include <thread>

#include <cstdio>

#include "laplacian_lines/precompute.h"
#include "laplacian_lines/threads.h"
#include "mesh_file.h"
#include "program.h"
#include "redraws.h"
#include "report.h"

namespace {

using namespace benchmarks;
using namespace laplacian_lines;

const Section kSize{"size", "Size"};
const Section kRedraw{"redraw_ms", "A redraw, ms, one thread"};
const Section kFrames{"frames", "Frames a second, one thread"};
const Section kToContours{"to_contours", "Times as long as contours alone"};
const Section kTwoThreads{"redraw_two_threads_ms", "A redraw, ms, two threads"};
const Section kThreads{"one_to_two_threads", "One thread : two threads"};
const Section kOnce{"once_s", "Once a mesh, s"};

PrecomputeOptions field_options(bool derivatives) {
    PrecomputeOptions options;
    options.curvature_derivatives = derivatives;
    return options;
}

/// The field without C and with it, on one thread and on two.
void add_fields(const TriangleMesh& mesh, MeshFigures& figures) {
    std::vector<Contender> contenders;
    for (const int threads : {1, 2})
        for (const bool derivatives : {false, true})
            contenders.push_back({std::string("field") + (derivatives ? "_with_derivatives" : "") +
                                      (threads > 1 ? "_two_threads" : ""),
                                  std::string("the field") + (derivatives ? " with C" : "") +
                                      (threads > 1 ? ", two threads" : ", one thread"),
                                  [&mesh, threads, derivatives](std::size_t) {
                                      set_thread_limit(threads);
                                      precompute(mesh, field_options(derivatives));
                                  },
                                  threads == 1});
    take_turns(contenders, {1, 3, 5, 8});
    for (const Contender& c : contenders)
        figures.add(kOnce, c.key, c.text, c.median());
}

/// What does not depend on the view is found at the first redraw.
void add_finding(Redraws& redraws, MeshFigures& figures) {
    for (const LineKind kind : {LineKind::Ridge, LineKind::Valley, LineKind::DemarcatingCurve}) {
        const NamedStyle found = only(kind);
        figures.add(kOnce, found.key, "finding " + found.text + ", one thread",
                    processor_seconds([&] { redraws.lines(0, found.style); }));
    }
}

void add_redraws(Redraws& redraws, double budget, MeshFigures& figures) {
    std::vector<Contender> contenders = redraws.kinds(1);
    for (Contender& contender : contenders)
        contender.by_processor = true;
    const std::size_t kinds = contenders.size();
    const std::vector<Contender> by_two = redraws.kinds(2);
    contenders.insert(contenders.end(), by_two.begin(), by_two.end());
    for (const Contender& contender : contenders)
        contender.run(0);  // allocates
    Turns turns;
    turns.cases = redraws.view_count();
    turns.budget = budget;
    const int rounds = take_turns(contenders, turns);
    std::fprintf(stderr, "medians of %d rounds\n", rounds);
    const double contours = contenders.front().median();
    for (std::size_t i = 0; i < kinds; ++i) {
        const Contender& one = contenders[i];
        const double time = one.median(), time_of_two = contenders[kinds + i].median();
        figures.add(kRedraw, one.key, one.text, 1e3 * time);
        figures.add(kFrames, one.key, one.text, 1 / time);
        figures.add(kToContours, one.key, one.text, time / contours);
        if (int(std::thread::hardware_concurrency()) < 2) continue;
        figures.add(kTwoThreads, one.key, one.text, 1e3 * time_of_two);
        figures.add(kThreads, one.key, one.text, time / time_of_two);
    }
}

MeshFigures measure(const std::string& file, double budget) {
    MeshFigures figures{test_meshes::mesh_name(file)};
    std::fprintf(stderr, "measuring %s\n", figures.name.c_str());
    const TriangleMesh mesh = test_meshes::read_mesh(file);
    figures.add(kSize, "triangles", "triangles", double(mesh.triangles.size()));
    const Field field = precompute(mesh, field_options(true));
    set_thread_limit(1);
    Redraws redraws(mesh, field);
    add_finding(redraws, figures);
    add_redraws(redraws, budget, figures);
    add_fields(mesh, figures);
    figures.add(kOnce, "extractor", "building the extractor, one thread",
                redraws.extractor_seconds());
    return figures;
}

}  // namespace

int main(int argc, char** argv) {
    double seconds = 20;
    std::string json;
    const std::vector<Option> options = {
        number("--seconds S", "for the redraws of a mesh (20)", seconds),
        text("--json FILE", "all figures", json)};
    return run_program(argc, argv, "MESH...", options, [&](const auto& files) {
        std::vector<MeshFigures> columns;
        for (const std::string& file : files)
            columns.push_back(measure(file, seconds));
        print_report(columns, json);
        return true;
    });
}
