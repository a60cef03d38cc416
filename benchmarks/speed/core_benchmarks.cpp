// SPDX-License-Identifier: GPL-3.0-or-later
// core_benchmarks [MESH...] [Google Benchmark's options]: single steps of the core. Without a MESH,
// a torus of some 70,000 triangles. Redraws: one iteration is all eyes of orbit().
#include <benchmark/benchmark.h>
#include <thread>

#include <cstdio>
#include <memory>

#include "field_work.h"
#include "generators.h"
#include "laplacian_lines/precompute.h"
#include "laplacian_lines/threads.h"
#include "mesh_file.h"
#include "redraws.h"

namespace {

using namespace benchmarks;
using namespace laplacian_lines;
using benchmark::State;

/// What steps need of a mesh, made when the first one asks for it.
struct Made {
    TriangleMesh mesh;
    std::unique_ptr<Field> field = {};
    std::unique_ptr<LaplacianAlone> laplacian = {};
    std::unique_ptr<LineExtractor> extractor = {};

    template <class T, class... Arguments>
    static T& demand(std::unique_ptr<T>& made, Arguments&&... arguments) {
        if (!made) made = std::make_unique<T>(arguments...);
        return *made;
    }
    const Field& get_field() {
        if (!field) field = std::make_unique<Field>(precompute(mesh));
        return *field;
    }
    double vertices() const { return double(mesh.positions.size()); }
};

benchmark::Counter per_item(double items) {
    return benchmark::Counter(
        items, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// √h in mean edges; 0: automatic.
void run_precompute(State& state, Made& made, double size) {
    PrecomputeOptions options;
    options.kernel_size = size * measure_scale(made.mesh).mean_edge;
    const PeakMemory memory;
    for (auto _ : state)
        benchmark::DoNotOptimize(precompute(made.mesh, options).normals.data());
    state.counters["peak_bytes_per_vertex"] = memory.bytes() / made.vertices();
    state.counters["per_vertex"] = per_item(made.vertices());
}

/// Δn alone; √h in mean edges.
void run_laplacian(State& state, Made& made, double size, Summation summation) {
    const LaplacianAlone& laplacian = Made::demand(made.laplacian, made.mesh);
    for (auto _ : state)
        benchmark::DoNotOptimize(laplacian.compute(size, summation).data());
    state.counters["per_vertex"] = per_item(double(laplacian.vertex_count()));
}

void run_extractor_build(State& state, Made& made) {
    made.get_field();
    std::size_t bytes = 0;
    for (auto _ : state)
        bytes = LineExtractor(made.mesh, made.get_field()).memory();
    state.counters["bytes_per_vertex"] = double(bytes) / made.vertices();
    state.counters["per_vertex"] = per_item(made.vertices());
}

void run_extract(State& state, Made& made) {
    const LineExtractor& extractor = Made::demand(made.extractor, made.mesh, made.get_field());
    const std::vector<View> views = orbit(made.mesh);
    ExtractionScratch scratch;
    LineSet lines;
    extractor.extract(views[0], {}, scratch, lines);  // builds what is built once
    std::size_t segments = 0;
    for (auto _ : state) {
        segments = 0;
        for (const View& view : views) {
            extractor.extract(view, {}, scratch, lines);
            segments += lines.segment_count();
        }
    }
    state.counters["segments"] = double(segments) / kEyes;
    state.counters["per_frame"] = per_item(kEyes);
}

/// On one thread, and on all.
template <class Run>
void add(const std::string& name, Run run) {
    for (const int threads : {1, int(std::thread::hardware_concurrency())})
        benchmark::RegisterBenchmark((name + "/threads:" + std::to_string(threads)).c_str(),
                                     [run, threads](State& state) {
                                         set_thread_limit(threads);
                                         run(state);
                                     })
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime();
}

void add_steps(const std::string& name, Made& made) {
    for (const char* size : {"0", "2", "5", "10", "20"})
        add("precompute/kernel:" + std::string(size) + "/" + name,
            [&made, size](State& s) { run_precompute(s, made, std::atof(size)); });
    // Where the two ways cost the same, the choice should change.
    for (const char* size : {"2", "2.5", "3", "3.5", "5", "10", "20"})
        for (const auto& [way, summation] : {std::pair("laplacian", Summation::Fastest),
                                             {"laplacian_grid", Summation::Grid},
                                             {"laplacian_direct", Summation::Direct}})
            add(std::string(way) + "/kernel:" + size + "/" + name,
                [&made, size, summation = summation](State& s) {
                    run_laplacian(s, made, std::atof(size), summation);
                });
    add("build_extractor/" + name, [&made](State& s) { run_extractor_build(s, made); });
    add("extract/" + name, [&made](State& s) { run_extract(s, made); });
}

}  // namespace

int main(int argc, char** argv) try {
    benchmark::Initialize(&argc, argv);
    std::vector<std::unique_ptr<Made>> meshes;
    const auto add_mesh = [&](const std::string& name, const TriangleMesh& mesh) {
        meshes.push_back(std::make_unique<Made>(Made{mesh}));
        add_steps(name, *meshes.back());
    };
    for (int i = 1; i < argc; ++i)
        add_mesh(test_meshes::mesh_name(argv[i]), test_meshes::read_mesh(argv[i]));
    if (argc == 1) add_mesh("torus", test_meshes::torus(264, 132, 0.15).mesh);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
} catch (const std::exception& error) {
    std::fprintf(stderr, "core_benchmarks: %s\n", error.what());
    return 1;
}
