// SPDX-License-Identifier: GPL-3.0-or-later
#include "precompute_times.h"

#include <omp.h>

#include <algorithm>

#include "extraction_times.h"
#include "laplacian_alone.h"
#include "laplacian_lines/precompute.h"
#include "naive_belkin.h"
#include "peak_memory.h"
#include "turns.h"

namespace benchmarks {

using namespace laplacian_lines;

namespace {

constexpr std::size_t kLargestForPlainSum = 1'000'000;  // triangles; it takes minutes above

Turns turns_for(const TriangleMesh& mesh) {
    Turns turns;
    turns.least_rounds = mesh.triangles.size() > kLargestForPlainSum ? 1 : 3;
    turns.most_rounds = 5;
    turns.budget = 4;
    return turns;
}

/// On one thread and on two, in turn.
template <class Work>
void time_alternately(const TriangleMesh& mesh, const std::string& text, const std::string& key,
                      Work work, MeshFigures& figures) {
    std::vector<Contender> contenders = {
        {key, text + ", one thread", [&](std::size_t) { work(1); }}};
    if (omp_get_num_procs() > 1)
        contenders.push_back(
            {key + "_two_threads", text + ", two threads", [&](std::size_t) { work(2); }});
    take_turns(contenders, turns_for(mesh));
    for (const Contender& c : contenders)
        figures.add(kBuilding, c.key, c.text, c.best());
}

}  // namespace

void add_precompute(const TriangleMesh& mesh, double kernel_size, MeshFigures& figures) {
    PrecomputeOptions options;
    options.kernel_size = kernel_size;
    Field field;
    double peak = 0;
    const auto compute = [&](int threads) {
        omp_set_num_threads(threads);
        field = Field();  // or two would be in memory at the end
        const PeakMemory memory;
        field = precompute(mesh, options);
        peak = std::max(peak, memory.bytes());
    };
    time_alternately(mesh, "the whole field", "field", compute, figures);
    const double scale = kernel_size / field.scale.mean_edge;
    const LaplacianAlone laplacian(mesh);
    const auto sum = [&](int threads) {
        omp_set_num_threads(threads);
        laplacian.compute(scale);
    };
    time_alternately(mesh, "Δn alone", "laplacian", sum, figures);
    omp_set_num_threads(omp_get_num_procs());
    if (mesh.triangles.size() <= kLargestForPlainSum)
        figures.add(kBuilding, "plain_sum", "Δn alone by a plain sum over cells, one thread",
                    seconds([&] { naive_belkin(mesh, field.normals, field.scale.kernel_size); }));
    figures.add(kMemory, "precompute_peak", "precompute at its peak, above the mesh",
                peak / double(mesh.positions.size()));
}

}  // namespace benchmarks
