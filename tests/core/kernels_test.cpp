// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "helpers.h"
#include "laplacian_lines/precompute.h"
#include "laplacian_lines/precompute_options.h"

namespace {

using namespace laplacian_lines;

TEST(Kernels, OfDrawingsAreWithinTheirRange) {
    const TriangleMesh mesh = test_meshes::bumpy_sphere(6, 0.15).mesh;
    const FieldScale scale = measure_scale(mesh);
    const KernelRange range = drawn_kernel_range(scale.mean_edge, scale.diagonal);
    PrecomputeOptions options;
    ASSERT_GT(range.most, 1.2 * range.least);
    for (const double wanted : {1e-6 * range.least, 1.1 * range.least, 1e6 * range.most}) {
        options.drawn_kernel_size = wanted;
        EXPECT_NEAR(measure_scale(mesh, options).kernel_size,
                    std::min(std::max(wanted, range.least), range.most), 1e-9 * range.most);
    }
    EXPECT_DOUBLE_EQ(drawn_kernel_range(0.1, 1).most, 0.13);
}

}  // namespace
