// SPDX-License-Identifier: GPL-3.0-or-later
// speed [--benchmark_...] FILE: times of fields, redraws and drawings of a mesh, and of a simple
// loop that finds contours, for comparison.
#include <benchmark/benchmark.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/line_mixture.h"
#include "laplacian_lines/precompute.h"
#include "laplacian_lines/threads.h"
#include "line_drawing/make_sheet.h"
#include "line_drawing/view_painter.h"
#include "line_drawing/words.h"
#include "mesh_files/mesh_file.h"

namespace {

using namespace laplacian_lines;

constexpr int kEyes = 24;
constexpr double kOrbitRadius = 1.25;  // in diagonals
constexpr int kWindow = 1000;          // pixels

TriangleMesh read_mesh(const std::string& name) {
    const auto format =
        mesh_files::format_of(line_drawing::lower(name.substr(name.rfind('.') + 1)));
    std::ifstream file(name, std::ios::binary);
    if (!file || !format) throw std::runtime_error(name + " is no mesh that can be read");
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    mesh_files::MeshInFile read = mesh_files::read_mesh(*format, bytes);
    if (!read.defect.empty()) throw std::runtime_error(name + ": " + read.defect);
    return std::move(read.mesh);
}

/// Perspective views all around a mesh, a little from above.
std::vector<View> orbit(const TriangleMesh& mesh) {
    const Eigen::AlignedBox3d box = line_drawing::bounds_of(mesh);
    std::vector<View> views;
    for (int i = 0; i < kEyes; ++i) {
        const double angle = 2 * M_PI * i / kEyes;
        const Eigen::Vector3d direction(std::cos(angle), 0.4, std::sin(angle));
        views.push_back(View::perspective(box.center() + kOrbitRadius * box.diagonal().norm() *
                                                             direction.normalized()));
    }
    return views;
}

/// A window around the mesh for an eye, in perspective.
line_drawing::WindowView window_of(const Eigen::Vector3d& eye, const TriangleMesh& mesh) {
    const Eigen::Vector3d back = (eye - line_drawing::bounds_of(mesh).center()).normalized(),
                          right = Eigen::Vector3d::UnitY().cross(back).normalized();
    const line_drawing::ViewFrame frame =
        line_drawing::frame_of_axes("", back, back.cross(right), eye);
    Eigen::Matrix4d to_eye = Eigen::Matrix4d::Identity(), projection = to_eye;
    to_eye.topLeftCorner<3, 3>() << frame.right.transpose(), frame.up.transpose(),
        frame.towards_viewer.transpose();
    to_eye.topRightCorner<3, 1>() = -to_eye.topLeftCorner<3, 3>() * eye;
    projection.topLeftCorner<2, 2>() *= 2 * kOrbitRadius;  // the diagonal fills it
    projection.bottomRows<2>() << 0, 0, -1, -1, 0, 0, -1, 0;
    return {frame, projection * to_eye, {kWindow, kWindow}};
}

/// All zeros of n·l in one loop over the triangles, in floats and on one thread: nothing is
/// filtered or traced.
class BaselineContours {
public:
    BaselineContours(const TriangleMesh& mesh, const Field& field)
        : triangles_(mesh.triangles), normals_(field.normals), values_(mesh.positions.size()) {
        for (const Eigen::Vector3d& p : mesh.positions)
            positions_.push_back(p.cast<float>());
    }

    /// Pairs of points.
    const std::vector<Eigen::Vector3f>& extract(const View& view) {
        const Eigen::Vector3f eye = view.eye.cast<float>();
        for (std::size_t v = 0; v < values_.size(); ++v)
            values_[v] = normals_[v].dot(eye - positions_[v]);
        segments_.clear();
        for (const Triangle& t : triangles_)
            for (std::size_t k = 0; k < 3; ++k)
                if (const auto a = t[k], b = t[(k + 1) % 3]; (values_[a] < 0) != (values_[b] < 0)) {
                    const float s = values_[a] / (values_[a] - values_[b]);
                    segments_.push_back((1 - s) * positions_[a] + s * positions_[b]);
                }
        return segments_;
    }

private:
    const std::vector<Triangle>& triangles_;
    const std::vector<Eigen::Vector3f>& normals_;
    std::vector<Eigen::Vector3f> positions_, segments_;
    std::vector<float> values_;
};

/// What the benchmarks are of.
struct Subject {
    const TriangleMesh& mesh;
    Field field = precompute(mesh);
    std::vector<View> views = orbit(mesh);
    LineExtractor extractor{mesh, field};
};

/// Each iteration calls work(i).
template <class Work>
benchmark::internal::Benchmark* add(const std::string& name, Work work) {
    return benchmark::RegisterBenchmark(name.c_str(), [work](benchmark::State& state) mutable {
        std::size_t i = 0;
        work(i);  // warm up: allocations and caches
        for (auto _ : state)
            work(i++);
    });
}

void add_redraw(const std::string& name, const Subject& of, const LineKindSet& shown, int threads) {
    LineStyle style;
    style.shows = shown;
    add("redraw/" + name, [&of, style, threads, lines = LineSet(),
                           scratch = std::make_shared<ExtractionScratch>()](std::size_t i) mutable {
        set_thread_limit(threads);
        of.extractor.extract(of.views[i % of.views.size()], style, *scratch, lines);
        set_thread_limit(0);
    })->Unit(benchmark::kMicrosecond);
}

/// `full` has derivatives, and is for kinds that need them: they take memory.
void add_redraws(const Subject& plain, const Subject& full) {
    for (const LineKindDescription& kind : kLineKinds)
        add_redraw(kind.key, kind.needs_derivatives ? full : plain, only_kinds({kind.kind}), 1);
    add_redraw("default", plain, LineStyle().shows, 1);
    add_redraw("default_all_threads", plain, LineStyle().shows, 0);
    add_redraw("all_kinds", full, all_kinds(), 1);
    add("redraw/plain_contours", [&plain, contours = BaselineContours(plain.mesh, plain.field)](
                                     std::size_t i) mutable {
        benchmark::DoNotOptimize(contours.extract(plain.views[i % plain.views.size()]).data());
    })->Unit(benchmark::kMicrosecond);
}

/// Of work on all threads.
template <class Work>
void add_long(const char* name, Work work) {
    add(name, work)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
}

void add_once_a_mesh(const Subject& of) {
    add_long("field", [&of](auto) { precompute(of.mesh); });
    add_long("derivatives",
             [&of, field = of.field](auto) mutable { add_curvature_derivatives(of.mesh, field); });
    add_long("extractor", [&of](auto) { LineExtractor(of.mesh, of.field); });
    line_drawing::SheetOptions options;
    options.views = line_drawing::parse_views("30,20", options.up);
    add_long("view_on_paper", [&of, options](auto) {
        line_drawing::make_sheets({{of.mesh, &of.field}}, {options});
    });
}

/// What a window draws when it comes to rest, once its mesh is ready.
void add_view_at_rest(const Subject& of) {
    std::vector<line_drawing::WindowView> windows;
    for (const View& view : of.views)
        windows.push_back(window_of(view.eye, of.mesh));
    auto painter = std::make_shared<line_drawing::ViewPainter>(
        line_drawing::Objects{{of.mesh, &of.field, {}, &of.extractor}});
    add_long("view_at_rest", [painter, windows](std::size_t i) {
        painter->paint(windows[i % windows.size()], {}, {line_drawing::Ink()}, true);
    });
}

}  // namespace

int main(int argc, char** argv) try {
    benchmark::Initialize(&argc, argv);
    if (argc != 2) throw std::runtime_error("a mesh has to be named: speed [--benchmark_...] FILE");
    const TriangleMesh mesh = read_mesh(argv[1]);
    const Subject plain{mesh};
    Field field = plain.field;
    add_curvature_derivatives(mesh, field);
    const Subject full{mesh, std::move(field)};
    const auto bytes = double(plain.extractor.memory());
    benchmark::AddCustomContext("mesh", argv[1]);
    benchmark::AddCustomContext("triangles", std::to_string(mesh.triangles.size()));
    benchmark::AddCustomContext("extractor, bytes a vertex",
                                std::to_string(int(bytes / double(mesh.positions.size()))));
    add_once_a_mesh(plain);
    add_view_at_rest(plain);
    add_redraws(plain, full);
    benchmark::RunSpecifiedBenchmarks();
} catch (const std::exception& error) {
    std::fprintf(stderr, "speed: %s\n", error.what());
    return 1;
}
