// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace laplacian_lines {

constexpr std::size_t kLanes = 16;  ///< targets that are summed at once

/// A vertex that others sum over. Positions are relative to the group's centre.
struct alignas(32) GaussianSource {
    float x, y, z, mass, nx, ny, nz, unused;
};

/// Copies those of `count` sources that lie, after `shift` was added to all their members, within
/// the given distance of a box around the origin. `kept` has room for all. Returns how many.
std::size_t collect_sources(const GaussianSource* sources, std::size_t count,
                            const GaussianSource& shift, const float half_size[3],
                            float squared_distance, GaussianSource* kept);

/// Up to kLanes vertices that sum over their neighbours; unused lanes may repeat others.
struct GaussianTargets {
    alignas(64) float x[kLanes], y[kLanes], z[kLanes];
    alignas(64) float nx[kLanes], ny[kLanes], nz[kLanes];
    alignas(64) float squared_cutoff[kLanes];
    alignas(64) float exponent[kLanes];  ///< −log2(e)/(4h): exp2(exponent·|q−p|²)
    float normal_exponent;  ///< −log2(e) falloff: exp2(normal_exponent·|n_q−n_p|²)
    float facing;           ///< 1: times facing_weight(n_q·n_p); 0: not
};

/// Sums of one group; normals are differences n_q − n_p, since Σ w n_q − n_p Σ w would cancel.
struct GaussianLaneSums {
    alignas(64) float mass[kLanes], mx[kLanes], my[kLanes], mz[kLanes];
    alignas(64) float nx[kLanes], ny[kLanes], nz[kLanes];
};

/// Sums all sources for each target. Runs with the widest vectors the processor has.
void sum_gaussians(const GaussianTargets& targets, const GaussianSource* sources,
                   std::size_t source_count, GaussianLaneSums& sums);

}  // namespace laplacian_lines
