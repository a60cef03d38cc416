// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laplacian_lines/precompute_options.h"
#include "laplacian_lines/triangle_mesh.h"

/// The field's definitions, plainly: double precision, mesh units, all pairs of vertices. For clean
/// meshes.
namespace reference {

using laplacian_lines::TriangleMesh;
using Vectors = std::vector<Eigen::Vector3d>;

double mean_edge(const TriangleMesh& mesh);
double diagonal(const TriangleMesh& mesh);
std::vector<double> masses(const TriangleMesh& mesh);
Vectors normals(const TriangleMesh& mesh, laplacian_lines::NormalWeighting weighting);

/// KernelMode::Adaptive: √h(p)/√h.
std::vector<double> relative_sizes(const TriangleMesh& mesh);

struct Smoothing {
    std::vector<double> sigma;   ///< by vertex
    double cutoff = 3;           ///< in sigma
    double bilateral_angle = 0;  ///< degrees; 0: Gaussian
};
Vectors smoothed(const TriangleMesh& mesh, const Vectors& normals, const Smoothing& smoothing);

/// Eq. 2 over all vertices, without cutoff and corrections.
Vectors laplacian(const TriangleMesh& mesh, const Vectors& normals,
                  const std::vector<double>& kernel_sizes, bool skip_opposite_sheet);

}  // namespace reference
