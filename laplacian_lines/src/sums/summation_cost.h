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

/// Predicted times on one thread, in units of what the direct sum takes for a thousand pairs of
/// vertices (about a microsecond). They depend on the mesh and the kernel only, not on a clock.
struct SummationCosts {
    double direct = 0;
    double grid = 0;  ///< infinite if the grid would need too much memory

    Summation fastest() const { return grid < direct ? Summation::Grid : Summation::Direct; }
};

/// The same for looking at all vertices within `radius` of each vertex.
double pairs_cost(const SpatialTree& tree, double radius);

/// @throws Error(TooCostly), whose sentence ends with the advice, if the cost is that of minutes.
void refuse_endless_sum(double cost, const char* advice);

/// The kernel's cutoff counts for the direct sum, the resolution for the grid.
SummationCosts summation_costs(const PreparedMesh& mesh, const SpatialTree& tree,
                               const GaussianKernel& kernel, const GridResolution& resolution);

}  // namespace laplacian_lines
