// SPDX-License-Identifier: GPL-3.0-or-later
// core_benchmarks [MESH...] [Google Benchmark's options]
// Generated meshes and the given files (OBJ, PLY, or either with .gz; also from the variable
// LAPLACIAN_LINES_MESH). Extraction: one iteration is an orbit of 24 eyes at 1.25 D.
#include <benchmark/benchmark.h>
#include <omp.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>

#include "generators.h"
#include "laplacian_alone.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/precompute.h"
#include "mesh_file.h"
#include "naive_belkin.h"
#include "naive_lines.h"
#include "orbit.h"
#include "peak_memory.h"

namespace {

using namespace laplacian_lines;

/// A mesh that is generated or read when the first benchmark asks for it.
class BenchmarkMesh {
public:
    BenchmarkMesh(std::string name, std::function<TriangleMesh()> make)
        : name_(std::move(name)), make_(std::move(make)) {}

    const std::string& name() const { return name_; }
    const TriangleMesh& mesh() {
        if (!mesh_) mesh_ = std::make_unique<TriangleMesh>(make_());
        return *mesh_;
    }
    const Field& field() {
        if (!field_) field_ = std::make_unique<Field>(precompute(mesh()));
        return *field_;
    }
    const benchmarks::LaplacianAlone& laplacian_alone() {
        if (!laplacian_) laplacian_ = std::make_unique<benchmarks::LaplacianAlone>(mesh());
        return *laplacian_;
    }
    const LineExtractor& extractor() {
        if (!extractor_) extractor_ = std::make_unique<LineExtractor>(mesh(), field());
        return *extractor_;
    }

private:
    std::string name_;
    std::function<TriangleMesh()> make_;
    std::unique_ptr<TriangleMesh> mesh_;
    std::unique_ptr<Field> field_;
    std::unique_ptr<benchmarks::LaplacianAlone> laplacian_;
    std::unique_ptr<LineExtractor> extractor_;
};

benchmark::Counter per_item(double items) {
    return benchmark::Counter(
        items, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// √h in mean edges; 0: automatic.
void run_precompute(benchmark::State& state, BenchmarkMesh& mesh, int threads, double size) {
    omp_set_num_threads(threads);
    PrecomputeOptions options;
    options.kernel_size = size * measure_scale(mesh.mesh()).mean_edge;
    const double vertices = double(mesh.mesh().positions.size());
    const benchmarks::PeakMemory memory;
    for (auto _ : state)
        benchmark::DoNotOptimize(precompute(mesh.mesh(), options).normals.data());
    state.counters["triangles"] = double(mesh.mesh().triangles.size());
    state.counters["peak_bytes_per_vertex"] = memory.bytes() / vertices;
    state.counters["per_vertex"] = per_item(vertices);
}

/// Δn alone; √h in mean edges.
void run_laplacian(benchmark::State& state, BenchmarkMesh& mesh, int threads, double size,
                   Summation summation) {
    omp_set_num_threads(threads);
    const benchmarks::LaplacianAlone& laplacian = mesh.laplacian_alone();
    for (auto _ : state)
        benchmark::DoNotOptimize(laplacian.compute(size, summation).data());
    state.counters["per_vertex"] = per_item(double(laplacian.vertex_count()));
}

/// The same without corrections and normals, by a plain sum; once, since it takes long.
void run_naive_belkin(benchmark::State& state, BenchmarkMesh& mesh, double size) {
    const double kernel_size = size * mesh.field().scale.mean_edge;
    for (auto _ : state)
        benchmark::DoNotOptimize(
            benchmarks::naive_belkin(mesh.mesh(), mesh.field().normals, kernel_size).data());
    state.counters["per_vertex"] = per_item(double(mesh.mesh().positions.size()));
}

void run_extractor_build(benchmark::State& state, BenchmarkMesh& mesh) {
    mesh.field();
    std::size_t bytes = 0;
    for (auto _ : state)
        bytes = LineExtractor(mesh.mesh(), mesh.field()).memory();
    state.counters["bytes_per_vertex"] = double(bytes) / double(mesh.mesh().positions.size());
    state.counters["per_vertex"] = per_item(double(mesh.mesh().positions.size()));
}

void report_frames(benchmark::State& state, const TriangleMesh& mesh, std::size_t segments) {
    state.counters["triangles"] = double(mesh.triangles.size());
    state.counters["segments"] = double(segments) / kEyes;
    state.counters["per_frame"] = per_item(kEyes);
    state.counters["per_segment"] = per_item(double(segments));
}

void run_extract(benchmark::State& state, BenchmarkMesh& mesh, int threads,
                 const LineStyle& style) {
    omp_set_num_threads(threads);
    const std::vector<View> views = orbit(mesh.mesh());
    ExtractionScratch scratch;
    LineSet lines;
    mesh.extractor().extract(views[0], style, scratch, lines);  // builds what is built once
    std::size_t segments = 0;
    for (auto _ : state) {
        segments = 0;
        for (const View& view : views) {
            mesh.extractor().extract(view, style, scratch, lines);
            segments += lines.segment_count();
        }
    }
    report_frames(state, mesh.mesh(), segments);
}

void run_naive(benchmark::State& state, BenchmarkMesh& mesh, bool contours) {
    const std::vector<View> views = orbit(mesh.mesh());
    const benchmarks::PlainMesh plain(mesh.mesh());
    benchmarks::NaiveLines naive(plain,
                                 contours ? mesh.field().normals : mesh.field().laplacian_normals);
    std::vector<Eigen::Vector3f> points;
    std::size_t segments = 0;
    for (auto _ : state) {
        segments = 0;
        for (const View& view : views) {
            naive.extract(view, points);
            segments += points.size() / 2;
        }
    }
    report_frames(state, mesh.mesh(), segments);
}

std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

template <class Run>
void add(const std::string& name, Run run) {
    benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMillisecond)->UseRealTime();
}

void add_benchmarks(BenchmarkMesh& mesh) {
    LineStyle everything;
    everything.gradient_threshold = everything.strength_threshold = 0;
    everything.segment_slope = everything.line_slope = everything.shortest_line = 0;
    everything.reject_phantoms = false;
    everything.least_facing = -1;
    const int all = omp_get_num_procs();
    for (int threads : {1, all}) {
        const std::string suffix = "/" + mesh.name() + "/threads:" + std::to_string(threads);
        for (double size : {0., 2., 5., 10., 20.})
            add("precompute/kernel:" + (size > 0 ? short_number(size) : "auto") + suffix,
                [&mesh, threads, size](benchmark::State& state) {
                    run_precompute(state, mesh, threads, size);
                });
        for (double size : {2., 2.5, 3.5, 5., 10., 20.})
            add("laplacian/kernel:" + short_number(size) + suffix,
                [&mesh, threads, size](benchmark::State& state) {
                    run_laplacian(state, mesh, threads, size, Summation::Fastest);
                });
        add("extract" + suffix,
            [&mesh, threads](benchmark::State& state) { run_extract(state, mesh, threads, {}); });
        add("extract_unfiltered" + suffix, [&mesh, threads, everything](benchmark::State& state) {
            run_extract(state, mesh, threads, everything);
        });
        if (all == 1) break;
    }
    add("build_extractor/" + mesh.name(),
        [&mesh](benchmark::State& state) { run_extractor_build(state, mesh); });
    // Where the two ways cost the same, the choice should change.
    for (double size : {2., 2.5, 3., 3.5})
        for (bool grid : {false, true})
            add((grid ? "laplacian_grid/kernel:" : "laplacian_direct/kernel:") +
                    short_number(size) + "/" + mesh.name(),
                [&mesh, size, grid](benchmark::State& state) {
                    run_laplacian(state, mesh, 1, size, grid ? Summation::Grid : Summation::Direct);
                });
    for (int size : {2, 5})
        add("naive_belkin/kernel:" + std::to_string(size) + "/" + mesh.name(),
            [&mesh, size](benchmark::State& state) { run_naive_belkin(state, mesh, size); });
    add("naive_laplacian/" + mesh.name(),
        [&mesh](benchmark::State& state) { run_naive(state, mesh, false); });
    add("naive_contours/" + mesh.name(),
        [&mesh](benchmark::State& state) { run_naive(state, mesh, true); });
}

/// A torus with grooves and bumps of a few percent of its size, so that about as many lines are
/// drawn as on a statue.
TriangleMesh bumpy_torus(int columns) {
    const double turn = 2 * std::acos(-1.0);
    return test_meshes::grid_mesh(
        {columns, columns / 2, true, true, 0.15}, [=](double u, double v) -> Eigen::Vector3d {
            const double bumps = std::sin(20 * turn * u + 3 * std::sin(turn * v)) *
                                 std::sin(9 * turn * v + 2 * std::cos(3 * turn * u));
            const double tube = 0.4 + 0.025 * bumps, ring = 1 + tube * std::cos(turn * v);
            return {ring * std::cos(turn * u), ring * std::sin(turn * u),
                    tube * std::sin(turn * v)};
        });
}

std::vector<BenchmarkMesh> make_meshes(const std::vector<std::string>& files) {
    std::vector<BenchmarkMesh> meshes;
    meshes.emplace_back("torus_70k", [] { return test_meshes::torus(264, 132, 0.15).mesh; });
    meshes.emplace_back("bumpy_70k", [] { return bumpy_torus(264); });
    meshes.emplace_back("torus_870k", [] { return test_meshes::torus(932, 466, 0.15).mesh; });
    meshes.emplace_back("bumpy_870k", [] { return bumpy_torus(932); });
    for (const std::string& path : files) {
        const std::string name = path.substr(path.find_last_of('/') + 1);
        meshes.emplace_back(name, [path] { return test_meshes::read_mesh(path); });
    }
    return meshes;
}

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    std::vector<std::string> files(argv + 1, argv + argc);
    if (const char* path = std::getenv("LAPLACIAN_LINES_MESH")) files.push_back(path);
    std::vector<BenchmarkMesh> meshes = make_meshes(files);
    for (BenchmarkMesh& mesh : meshes)
        add_benchmarks(mesh);
    try {
        benchmark::RunSpecifiedBenchmarks();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    benchmark::Shutdown();
}
