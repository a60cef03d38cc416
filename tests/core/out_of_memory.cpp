// SPDX-License-Identifier: GPL-3.0-or-later
// Out of memory, the core throws std::bad_alloc, from any thread, and works afterwards.
//   out_of_memory allocations    fails one allocation after the other
//   out_of_memory MEGABYTES      limits the address space
#include <sys/resource.h>

#include <cstdio>
#include <fstream>
#include <new>
#include <string>

#include "allocation_hook.h"
#include "helpers.h"
#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace laplacian_lines;

LineSet all_of_it(const TriangleMesh& mesh, const PrecomputeOptions& options,
                  ExtractionScratch& scratch) {
    const Field field = precompute(mesh, options);
    const LineExtractor extractor(mesh, field);
    const View view = View::perspective(field.scale.diagonal * Eigen::Vector3d(1, 2, 1.5));
    LineStyle style;
    style.shows[LineKind::Crease] = true;
    style.whole_lines = true;
    const LineSet lines = extract_on_surface(extractor, view, style, scratch);
    return LineVisibility(mesh).parts(view, {lines}, {style.shows}).seen;
}

int fail(const char* what, long number) {
    std::printf("%s (allocation %ld)\n", what, number);
    return 1;
}

int fail_every_allocation(const PrecomputeOptions& options) {
    const TriangleMesh mesh = test_meshes::torus(36, 18, 0.2).mesh;
    ExtractionScratch scratch;
    const LineSet expected = all_of_it(mesh, options, scratch);
    long number = 0, failed = 0;
    for (bool finished = false; !finished; number += 1 + number / 64) {
        ExtractionScratch once_failed;
        allocation_hook::fail_after(number, number % 2 != 0);
        try {
            all_of_it(mesh, options, once_failed);
            finished = !allocation_hook::stop_failing();
            if (!finished) return fail("a failed allocation went unnoticed", number);
        } catch (const std::bad_alloc&) {
            allocation_hook::stop_failing();
            ++failed;
        }
        if (!helpers::same_lines(expected, all_of_it(mesh, options, once_failed)))
            return fail("other lines after an error", number);
    }
    std::printf("%ld of about %ld allocations failed\n", failed, number);
    return failed > 50 ? 0 : fail("too few allocations", number);
}

std::size_t address_space() {
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * 4096;
}

int limit_address_space(std::size_t megabytes) {
    const TriangleMesh mesh = test_meshes::torus(600, 300, 0.2).mesh;
    const rlim_t limit = address_space() + (megabytes << 20);
    const rlimit limits{limit, limit};
    if (setrlimit(RLIMIT_AS, &limits) != 0) return fail("no limit could be set", 0);
    std::string outcome = "finished";
    try {
        ExtractionScratch scratch;
        all_of_it(mesh, {}, scratch);
    } catch (const std::bad_alloc&) {
        outcome = "out of memory";
    }
    std::printf("%zu MB: %s\n", megabytes, outcome.c_str());
    return megabytes > 32 || outcome != "finished" ? 0 : fail("the limit had no effect", 0);
}

}  // namespace

int main(int count, char** arguments) {
    const std::string mode = count == 2 ? arguments[1] : "";
    if (mode.empty()) return fail("one argument: allocations or MEGABYTES", 0);
    if (mode != "allocations") return limit_address_space(std::stoul(mode));
    PrecomputeOptions other;
    other.kernel_mode = KernelMode::Adaptive;
    other.gradient_estimator = GradientEstimator::LeastSquares;
    other.kernel_size = 0.5;
    const int plain = fail_every_allocation({});
    return plain ? plain : fail_every_allocation(other);
}
