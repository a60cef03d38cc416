// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "sums/simd_grid.h"

namespace laplacian_lines {

// Σ m w(n_q·n_p) and Σ m w(n_q·n_p) n_q for any n_p, w = 1 or facing_weight(), from moments Σ m
// n_x^i n_y^j n_z^k that do not depend on p. The first group of 16 has degrees 0, 1 and 3 and
// suffices for w = 1; the second has degree 4, from which degree 2 follows since |n| = 1.

/// Of one vertex of mass m.
template <class Real, int Groups>
void set_moments(double mass, const Eigen::Vector3d& normal, GridNode<Real, Groups>& node);

/// Around p, for its normal.
struct ContractedMoments {
    double mass = 0;           ///< Σ m w
    Eigen::Vector3d normal;    ///< Σ m w n_q
    Eigen::Vector3d gradient;  ///< of the mass, as the derivatives in `sums`
};

/// `Groups` = 1: w = 1; 2: w = facing_weight().
template <class Real, int Groups>
ContractedMoments contract(const PointSums<Real, Groups>& sums, const Eigen::Vector3d& normal);

}  // namespace laplacian_lines
