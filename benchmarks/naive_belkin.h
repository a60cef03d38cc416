// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace benchmarks {

/// Δn by Belkin's operator as one would write it down: vertices in the cells of a regular grid of
/// the kernel's cutoff (6.1 √h, accuracy 1e-3), double precision, no corrections, one thread.
std::vector<Eigen::Vector3d> naive_belkin(const laplacian_lines::TriangleMesh& mesh,
                                          const std::vector<Eigen::Vector3f>& normals,
                                          double kernel_size);

}  // namespace benchmarks
