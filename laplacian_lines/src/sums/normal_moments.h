// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "sums/simd_grid.h"

namespace laplacian_lines {

/// Sets the moments of a mass m with the normal n_q: monomials of n_q times m, whose sums give
/// contract() what it needs for any normal of p.
void set_moments(double mass, const Eigen::Vector3d& normal, GridNode& node);

/// Sums over q around a point p, for its normal.
struct ContractedMoments {
    double mass = 0;           ///< Σ m w
    Eigen::Vector3d normal;    ///< Σ m w n_q
    Eigen::Vector3d gradient;  ///< of the mass, per cell along the grid's axes
};

/// From the sums at p, whose normal is n. `facing`: w = facing_weight(n_q·n), else 1.
ContractedMoments contract(const PointSums& sums, const Eigen::Vector3d& n, bool facing);

}  // namespace laplacian_lines
