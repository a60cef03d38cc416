// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "field/shape_operators.h"
#include "sums/gaussian_sums.h"
#include "sums/summation_cost.h"

namespace laplacian_lines {

/// Radius, in √h, beyond which the part `accuracy` of the kernel's second moment lies: the k with
/// (1 + u) exp(−u) = accuracy, u = k²/4.
double belkin_cutoff(double accuracy);

struct BelkinOptions {
    double accuracy = 1e-3;
    bool correct_borders = true;
    bool skip_opposite_sheet = true;
};

/// For the direct sum.
GaussianKernel belkin_kernel(const std::vector<float>& kernel_sizes, const BelkinOptions& options);

/// Δn, [N], local units, by L f(p) = 1/(4πh²) Σ_q m_q exp(−|q−p|²/4h) (f(q) − f(p)): M. Belkin, J.
/// Sun, Y. Wang, "Discrete Laplace Operator on Meshed Surfaces", SoCG 2008; Eq. 2 of Laplacian
/// Lines, its sum over triangles and corners written as one over vertices. "Skip Opposite Sheet"
/// multiplies the terms by facing_weight(n_q·n_p).
std::vector<Eigen::Vector3d> belkin_laplacian(const PreparedMesh& mesh, const SpatialTree& tree,
                                              const std::vector<Eigen::Vector3d>& normals,
                                              const std::vector<float>& kernel_sizes,
                                              const ShapeOperators& shape_operators,
                                              const BelkinOptions& options,
                                              const StageProgress& stage);

}  // namespace laplacian_lines
