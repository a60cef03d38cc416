// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace laplacian_lines {

constexpr std::size_t kLanes = 16;  ///< targets that are summed at once

/// A vertex that others sum over. Position and normal are relative to the group's references.
struct GaussianSource {
    float x, y, z, mass, nx, ny, nz, unused;
};

/// Up to kLanes vertices that sum over their neighbours; unused lanes may repeat others.
struct GaussianTargets {
    alignas(64) float x[kLanes], y[kLanes], z[kLanes];
    alignas(64) float nx[kLanes], ny[kLanes], nz[kLanes];  ///< unit normals, not relative
    alignas(64) float reference_cosine[kLanes];            ///< n_p · group's reference normal
    alignas(64) float squared_cutoff[kLanes];
    alignas(64) float exponent[kLanes];  ///< −log2(e)/(4h): exp2(exponent·|q−p|²)
    float normal_exponent;  ///< −2 log2(e) falloff: exp2(normal_exponent·(1−n_q·n_p))
    float least_cosine;     ///< sources with n_q·n_p below are left out
};

/// Sums of one group; normals relative to the group's reference.
struct GaussianLaneSums {
    alignas(64) float mass[kLanes], mx[kLanes], my[kLanes], mz[kLanes];
    alignas(64) float nx[kLanes], ny[kLanes], nz[kLanes];
};

/// Sums all sources for each target. Runs with the widest vectors the processor has.
void sum_gaussians(const GaussianTargets& targets, const GaussianSource* sources,
                   std::size_t source_count, GaussianLaneSums& sums);

}  // namespace laplacian_lines
