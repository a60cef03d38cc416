// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/triangle_mesh.h"

namespace reference {

struct PlainDerivatives {
    std::vector<Eigen::Vector3d> curvatures;   ///< S̄
    std::vector<Eigen::Vector4d> derivatives;  ///< C
};

/// S̄ and C as curvature_derivatives.h defines them, by one vertex after the other in double
/// precision and the mesh's own units, from the rest of the field. For clean meshes whose kernels
/// are not cut at the largest reach; quadratic in the number of vertices.
PlainDerivatives curvature_derivatives(const laplacian_lines::TriangleMesh& mesh,
                                       const laplacian_lines::Field& field);

}  // namespace reference
