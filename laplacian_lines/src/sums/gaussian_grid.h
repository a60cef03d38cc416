// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sums/gaussian_sums.h"
#include "sums/spline_kernel.h"

namespace laplacian_lines {

/// The same sums as gaussian_sums() without a cutoff and without normal_falloff, as exact as the
/// resolution, in a time that hardly depends on the kernel size.
///
/// Masses, times moments of the normals, are spread over the nodes of a grid by cubic B-splines,
/// convolved along x, y and z, and interpolated: R. W. Hockney and J. W. Eastwood, "Computer
/// Simulation Using Particles", 1981; L. Greengard and J. Strain, "The Fast Gauss Transform",
/// 1991, for the idea of summing Gaussians through a grid. The grid has nodes only near the
/// surface, and one slab of its blocks after the other is worked on.
GaussianSums grid_sums(const PreparedMesh& mesh, const std::vector<Eigen::Vector3d>& normals,
                       const GaussianKernel& kernel, const GridResolution& resolution,
                       const StageProgress& stage);

}  // namespace laplacian_lines
