// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace laplacian_lines {

constexpr std::uint32_t kTensorLanes = 16;  ///< targets of one sum

/// A vertex with a symmetric tensor S.
struct alignas(64) TensorSource {
    float x, y, z;
    float mass;
    float normal[3];
    float xx, yy, zz, yz, xz, xy;  ///< S
};

/// Vertices to sum at, each with its plane of u and v, by component and lane. Unused lanes may
/// repeat others.
struct TensorTargets {
    alignas(64) float position[3][kTensorLanes], normal[3][kTensorLanes];
    alignas(64) float u[3][kTensorLanes], v[3][kTensorLanes];
    float per_radius;  ///< 1 / distance within which sources count
};

/// Weighted sums of positions (x, y) in the plane, in radii, and of S(u,u), S(u,v), S(v,v); by
/// number and lane.
struct TensorSums {
    enum { kWeight, kX, kY, kXX, kXY, kYY, kEntries, kXEntries = 9, kYEntries = 12, kNumbers = 15 };
    alignas(64) float numbers[kNumbers][kTensorLanes];
};

/// See simd_sets.h.
struct TensorLoops {
    /// Weights are 4 mass · max(1 − d²/R², 0)² · facing_weight(n_q·n_p), d the distance, R the
    /// radius.
    void (*sum)(const TensorTargets& targets, const TensorSource* sources, std::size_t count,
                TensorSums& sums);
};

}  // namespace laplacian_lines
