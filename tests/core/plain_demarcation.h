// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/triangle_mesh.h"

namespace reference {

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
