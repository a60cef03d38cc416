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

/// S̄ and C as field_steps.h defines them, by one vertex after the other in double
/// precision and the mesh's own units, from the rest of the field. For clean meshes whose kernels
/// are not cut at the largest reach; quadratic in the number of vertices.
PlainDerivatives curvature_derivatives(const laplacian_lines::TriangleMesh& mesh,
                                       const laplacian_lines::Field& field);

/// A piece of a demarcating curve in a triangle, mesh coordinates.
struct DemarcatingPiece {
    Eigen::Vector3d ends[2];
    double strength[2];  ///< C(g, g, g) h_e at them, degrees
};

/// All pieces, triangle by triangle, written down plainly: of a mesh without anything to leave out,
/// and a field with curvature derivatives.
std::vector<DemarcatingPiece> demarcating_pieces(const laplacian_lines::TriangleMesh& mesh,
                                                 const laplacian_lines::Field& field);

}  // namespace reference
