// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sums/gaussian_sums.h"
#include "sums/spline_kernel.h"

namespace laplacian_lines {

/// As gaussian_sums() without cutoff and normal_falloff, as exact as the resolution, in a time that
/// hardly depends on the kernel size: masses times moments of the normals are spread over a grid by
/// cubic B-splines, convolved along x, y and z, and interpolated (R. W. Hockney and J. W. Eastwood,
/// "Computer Simulation Using Particles", 1981; the idea is from L. Greengard and J. Strain, "The
/// Fast Gauss Transform", 1991). Only nodes near the surface exist, and one slab of blocks is
/// worked on after the other.
GaussianSums grid_sums(const PreparedMesh& mesh, const std::vector<Eigen::Vector3d>& normals,
                       const GaussianKernel& kernel, const GridResolution& resolution,
                       const StageProgress& stage);

}  // namespace laplacian_lines
