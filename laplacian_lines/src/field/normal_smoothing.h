// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laplacian_lines/precompute_options.h"
#include "sums/gaussian_sums.h"

namespace laplacian_lines {

/// Replaces unit normals by the weighted mean of those around them, weighted by how much they face
/// the same way (facing_weight(n_q·n_p)). `sigma`: standard deviation of the Gaussian in local
/// units, times relative_sizes[v] at each vertex. Bilateral weights also fall with the difference
/// of the normals, with the standard deviation `bilateral_angle` in degrees, so that edges stay
/// sharp.
void smooth_normals(const PreparedMesh& mesh, const SpatialTree& tree,
                    const std::vector<float>& relative_sizes, double sigma,
                    const PrecomputeOptions& options, const StageProgress& stage,
                    std::vector<Eigen::Vector3d>& normals);

}  // namespace laplacian_lines
