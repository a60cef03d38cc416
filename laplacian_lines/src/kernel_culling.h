// SPDX-License-Identifier: GPL-3.0-or-later
// Leaves out whole clusters by bounds of n·l and ΔI.
// Included once by each of the files cluster_kernels_*.cpp.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cluster_kernels.h"
#include "kernel_vectors.h"

namespace laplacian_lines {
namespace KERNEL_NAMESPACE {

/// More than rounding does to a sum of products of about 1 with what it is a factor of.
constexpr float kRoundingMargin = 1e-5f;

/// Bounds of v·(e − w p) for v and p in balls, as middle and half range.
struct FormBounds {
    float middle[kFormGroup], range[kFormGroup];
};
static inline void bound_forms(const float* const vector[3], const float* vector_radius,
                               const ClusterStore& store, const float eye[4], std::size_t first,
                               FormBounds& bounds) {
    for (unsigned i = 0; i < kFormGroup; ++i) {
        const std::size_t c = first + i;
        const float x = eye[0] - eye[3] * store.centre[0][c],
                    y = eye[1] - eye[3] * store.centre[1][c],
                    z = eye[2] - eye[3] * store.centre[2][c];
        const float vx = vector[0][c], vy = vector[1][c], vz = vector[2][c];
        const float distance = __builtin_sqrtf(x * x + y * y + z * z);
        const float size = __builtin_sqrtf(vx * vx + vy * vy + vz * vz);
        const float reach = eye[3] * store.radius[c], spread = vector_radius[c];
        bounds.middle[i] = vx * x + vy * y + vz * z;
        // The forms are summed from e and v·p, which may be larger than what is left of them.
        const float summed =
            __builtin_fabsf(eye[0]) + __builtin_fabsf(eye[1]) + __builtin_fabsf(eye[2]) + eye[3];
        bounds.range[i] = spread * (distance + reach) + size * reach +
                          kRoundingMargin * (size + spread) * (summed + distance + reach);
    }
}

static std::size_t cull(const ClusterStore& store, const ExtractionTask& task, std::size_t begin,
                        std::size_t end, std::uint32_t* kept) {
    // The exact light's term has no bounds.
    const bool bounded = !task.exact_point_light;
    std::size_t count = 0;
    for (std::size_t first = begin; first < end; first += kFormGroup) {
        FormBounds facing, laplacian;
        bound_forms(store.normal, store.normal_radius, store, task.eye, first, facing);
        bound_forms(store.laplacian, store.laplacian_radius, store, task.light, first, laplacian);
        std::uint8_t keep[kFormGroup];
        for (unsigned i = 0; i < kFormGroup; ++i) {
            const float low = facing.middle[i] - facing.range[i],
                        high = facing.middle[i] + facing.range[i];
            // Refused by what is certain, so that nothing is where numbers are out of range.
            const bool contour = task.wanted[kContourStrips] & !(low >= 0) & !(high < 0);
            const bool changes = !(laplacian.middle[i] - laplacian.range[i] >= 0) &
                                 !(laplacian.middle[i] + laplacian.range[i] < 0);
            const bool line = task.wanted[kLaplacianStrips] & (changes | !bounded) &
                              !(high < task.least_scaled_facing);
            keep[i] = contour | line;
        }
        for (std::size_t c = first; c < first + kFormGroup && c < end; ++c) {
            kept[count] = std::uint32_t(c);
            count += keep[c - first];
        }
    }
    return count;
}

}  // namespace KERNEL_NAMESPACE
}  // namespace laplacian_lines
