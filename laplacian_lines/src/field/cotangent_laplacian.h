// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "mesh/prepared_mesh.h"

namespace laplacian_lines {

/// Δn of all vertices, [N], local units, with cotangent weights divided by the vertex mass:
/// U. Pinkall, K. Polthier, "Computing Discrete Minimal Surfaces and Their Conjugates", 1993.
/// Does not converge on irregular triangulations (the paper's Fig. 2); kept to compare with.
std::vector<Eigen::Vector3d> cotangent_laplacian(const PreparedMesh& mesh,
                                                 const std::vector<Eigen::Vector3d>& normals);

}  // namespace laplacian_lines
