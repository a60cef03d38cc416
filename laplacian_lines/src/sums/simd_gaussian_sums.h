// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace laplacian_lines {

constexpr std::size_t kTargets = 16;  ///< targets that are summed at once

/// Positions are relative to the centre of the targets' leaf, normals to its mean: less rounding.
struct alignas(32) GaussianSource {
    float x, y, z;
    float mass;  ///< in GaussianTargets::unit_mass
    float nx, ny, nz;
    float squared;  ///< x² + y² + z², of collected sources only
};

/// Unused lanes may repeat others.
struct GaussianTargets {
    alignas(64) float position[3][kTargets], normal[3][kTargets];
    float squared_cutoff;
    float exponent;     ///< −log2(e)/(4h): exp2(exponent·|q−p|²)
    float log2_cutoff;  ///< exponent·squared_cutoff
    float unit_mass;
    float mean_normal[3];
    float facing;  ///< 1: times facing_weight(n_q·n_p); 0: not
};

/// Σ w, Σ w (q − p) and Σ w (n_q − n_p), by target.
struct GaussianLaneSums {
    alignas(64) float mass[kTargets], moment[3][kTargets], normal[3][kTargets];
};

/// See simd_sets.h.
struct GaussianLoops {
    /// Sums all sources for each target.
    void (*sum)(const GaussianTargets& targets, const GaussianSource* sources,
                std::size_t source_count, GaussianLaneSums& sums);
    /// With errors of kQuickError, for targets within kQuickRadius √h of the leaf's centre: up to
    /// there, what quick_exp2() makes of exponents beyond its range can be masked out.
    void (*sum_quickly)(const GaussianTargets& targets, const GaussianSource* sources,
                        std::size_t source_count, GaussianLaneSums& sums);
};
constexpr double kQuickRadius = 8;

}  // namespace laplacian_lines
