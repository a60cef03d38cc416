// SPDX-License-Identifier: GPL-3.0-or-later
// Out of memory, at any allocation, the core throws std::bad_alloc, from any thread, and works
// afterwards.
#include <gtest/gtest.h>

#include <new>

#include "allocation_hook.h"
#include "helpers.h"
#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/precompute.h"
#include "with_threads.h"

namespace {

using namespace laplacian_lines;

LineSet all_of_it(const TriangleMesh& mesh, ExtractionScratch& scratch) {
    const Field field = helpers::complete_field(mesh);
    const LineExtractor extractor(mesh, field);
    const View view = View::perspective(field.scale.diagonal * Eigen::Vector3d(1, 2, 1.5));
    LineStyle style = helpers::all_kinds();
    style.whole_lines = true;
    const LineSet lines = extract_on_surface(extractor, view, style, scratch);
    return LineVisibility(mesh).parts(view, {lines}, {style.shows}).seen;
}

TEST(OutOfMemory, AtAnyAllocation) {
    const test_meshes::WithThreads scope(3);
    const TriangleMesh mesh = test_meshes::torus(24, 12, 0.2).mesh;
    ExtractionScratch scratch;
    const LineSet expected = all_of_it(mesh, scratch);
    ASSERT_FALSE(expected.lines.empty());
    int failed = 0;
    bool is_finished = false;
    for (long number = 0; !is_finished; number += 1 + number / 32) {
        ExtractionScratch once_failed;
        allocation_hook::fail_after(number);
        try {
            all_of_it(mesh, once_failed);
            is_finished = !allocation_hook::stop_failing();
            ASSERT_TRUE(is_finished) << "unnoticed: allocation " << number;
        } catch (const std::bad_alloc&) {
            allocation_hook::stop_failing();
            ++failed;
        }
        ASSERT_TRUE(helpers::same_lines(expected, all_of_it(mesh, once_failed))) << number;
    }
    EXPECT_GT(failed, 50);
}

}  // namespace
