// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sums/gaussian_sums.h"

namespace laplacian_lines {

struct GridResolution {
    double cell = 0;       ///< in √h
    double cutoff = 0;     ///< of the convolution along each axis, in √h
    bool is_exact = true;  ///< else floats are too coarse for the accuracy
};

/// The coarsest grid that gives Δn to a relative accuracy, 1e-6..0.1. `normal_turn`: RMS of √h‖S‖,
/// radians by which the normals turn within √h. It is about the share of the terms of Δn that does
/// not cancel on a smooth surface.
GridResolution grid_resolution(double accuracy, double normal_turn);

/// Predicted time on one thread. The unit is a thousand pairs in the direct sum, about a
/// microsecond. Depends on the mesh and the kernel, not on a clock.
struct SummationCosts {
    double direct = 0;
    double grid = 0;  ///< infinite if it would need too much memory or be inexact
};

/// The cost of visiting all vertices within `radius` of each vertex.
double pairs_cost(const SpatialTree& tree, double radius);

/// @throws Error(TooCostly), whose sentence ends with the advice, from half a minute on
void refuse_costly_sum(double cost, const char* advice);

/// The direct sum depends on the kernel's cutoff, the grid on the resolution.
SummationCosts summation_costs(const PreparedMesh& mesh, const SpatialTree& tree,
                               const GaussianKernel& kernel, const GridResolution& resolution);

}  // namespace laplacian_lines
