// SPDX-License-Identifier: GPL-3.0-or-later
// When memory runs out, the core throws std::bad_alloc, in whatever thread it happens, and goes on
// working afterwards.
//   out_of_memory allocations    fails one allocation after the other
//   out_of_memory MEGABYTES      limits the address space
#include <sys/resource.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <new>
#include <string>

#include "helpers.h"
#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/precompute.h"

namespace {

constexpr long kNever = -1;
std::atomic<long> allocations_left{kNever};  // until one fails
std::atomic<bool> fail_for_good{false};

void count_allocation() {
    if (allocations_left == kNever) return;
    const long left = allocations_left.fetch_sub(1);
    if (left == 0) {
        allocations_left = fail_for_good ? 0 : kNever;
        throw std::bad_alloc();
    }
}

void* checked(void* memory) {
    if (!memory) throw std::bad_alloc();
    return memory;
}

}  // namespace

void* operator new(std::size_t size) {
    count_allocation();
    return checked(std::malloc(size ? size : 1));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    count_allocation();
    const std::size_t step = static_cast<std::size_t>(alignment);
    return checked(std::aligned_alloc(step, (size + step - 1) / step * step));
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}

namespace {

using namespace laplacian_lines;

/// Everything the core does.
LineSet all_of_it(const TriangleMesh& mesh, const PrecomputeOptions& options,
                  ExtractionScratch& scratch) {
    const Field field = precompute(mesh, options);
    const LineExtractor extractor(mesh, field);
    const View view = View::perspective(field.scale.diagonal * Eigen::Vector3d(1, 2, 1.5));
    LineSet lines;
    LineStyle style;
    style.creases = true;
    extractor.extract(view, style, scratch, lines);
    return LineVisibility(mesh, field.scale).visible_parts(view, lines);
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
        fail_for_good = number % 2 != 0;
        ExtractionScratch once_failed;
        allocations_left = number;
        try {
            all_of_it(mesh, options, once_failed);
            finished = allocations_left != kNever;
            allocations_left = kNever;
            if (!finished) return fail("a failed allocation went unnoticed", number);
        } catch (const std::bad_alloc&) {
            allocations_left = kNever;
            ++failed;
        }
        if (!helpers::same_lines(expected, all_of_it(mesh, options, once_failed)))
            return fail("other lines after an error", number);
    }
    std::printf("%ld of about %ld allocations failed\n", failed, number);
    return failed > 50 ? 0 : fail("too few allocations", number);
}

/// Bytes of the address space that are in use.
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
