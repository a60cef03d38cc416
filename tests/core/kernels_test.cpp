// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel size that a drawing asks for.
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
    const double least = scale.mean_edge, most = 0.04 * scale.diagonal;
    ASSERT_GT(most, 1.2 * least);
    const auto drawn = [](const TriangleMesh& of, double wanted) {
        PrecomputeOptions options;
        options.drawn_kernel_size = wanted;
        return measure_scale(of, options).kernel_size;
    };
    for (const double wanted : {1e-6 * least, 1.1 * least, 1e6 * most})
        EXPECT_NEAR(drawn(mesh, wanted), std::clamp(wanted, least, most), 1e-9 * most);
    const TriangleMesh coarse = test_meshes::bumpy_sphere(2, 0.15).mesh;
    const FieldScale large = measure_scale(coarse);
    ASSERT_GT(large.mean_edge, 0.04 * large.diagonal);
    EXPECT_NEAR(drawn(coarse, 1e6), large.mean_edge, 1e-9);
}

}  // namespace
