// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "field/cubic_form.h"
#include "field/symmetric_tensor.h"
#include "mesh/prepared_mesh.h"
#include "mesh/vertex_ranges.h"
#include "system/parallel.h"

namespace laplacian_lines {

/// A vertex whose S is differentiated, local units.
struct CurvedVertex {
    Eigen::Vector3d normal, u, v;  ///< orthonormal
    SymmetricTensor shape_operator;
};

/// The derivative of S of all vertices, [N], by differences within the triangles at each, in the
/// frames (u, v): S is linear between the corners of a triangle, in the triangle's plane, and what
/// comes out is made symmetric, as it is on smooth surfaces (Codazzi). S. Rusinkiewicz, "Estimating
/// Curvatures and Their Derivatives on Triangle Meshes", 3DPVT 2004, section 4, without its least
/// squares. 0 where no triangle faces as its corners do.
std::vector<CubicForm> ring_derivatives(const PreparedMesh& mesh, const VertexRanges& ranges,
                                        const std::vector<CurvedVertex>& vertices);

}  // namespace laplacian_lines
