// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sums/gaussian_sums.h"
#include "sums/spline_kernel.h"

namespace laplacian_lines {

enum class Summation {
    Fastest,  ///< the one of lower predicted cost
    Direct,   ///< gaussian_sums()
    Grid,     ///< grid_sums()
};

/// Predicted time on one thread, in that of a thousand pairs in the direct sum, about a
/// microsecond. Depends on the mesh and the kernel, not on a clock.
struct SummationCosts {
    double direct = 0;
    double grid = 0;  ///< infinite if the grid would need too much memory

    Summation fastest() const { return grid < direct ? Summation::Grid : Summation::Direct; }
};

/// Of looking at all vertices within `radius` of each vertex.
double pairs_cost(const SpatialTree& tree, double radius);

/// @throws Error(TooCostly), whose sentence ends with the advice, if it would take minutes
void refuse_endless_sum(double cost, const char* advice);

/// The kernel's cutoff counts for the direct sum, the resolution for the grid.
SummationCosts summation_costs(const PreparedMesh& mesh, const SpatialTree& tree,
                               const GaussianKernel& kernel, const GridResolution& resolution);

}  // namespace laplacian_lines
