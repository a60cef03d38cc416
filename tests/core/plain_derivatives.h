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

/// S̄ and C as in field_steps.h, vertex by vertex, in double precision and mesh units, from the
/// rest of the field. For clean meshes whose kernels are not cut at the largest reach; quadratic.
PlainDerivatives curvature_derivatives(const laplacian_lines::TriangleMesh& mesh,
                                       const laplacian_lines::Field& field);

/// In a triangle, mesh coordinates.
struct DemarcatingPiece {
    Eigen::Vector3d ends[2];
    double strength[2];  ///< C(g, g, g) h_e at them, degrees
};

/// Triangle by triangle, for a mesh with nothing to leave out and a field with derivatives.
std::vector<DemarcatingPiece> demarcating_pieces(const laplacian_lines::TriangleMesh& mesh,
                                                 const laplacian_lines::Field& field);

}  // namespace reference
