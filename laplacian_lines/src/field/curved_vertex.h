// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "field/symmetric_tensor.h"
#include "laplacian_lines/field.h"
#include "laplacian_lines/tangent_frame.h"
#include "mesh/prepared_mesh.h"

namespace laplacian_lines {

/// A vertex whose S is differentiated, local units.
struct CurvedVertex {
    Eigen::Vector3d normal, u, v;  ///< orthonormal
    SymmetricTensor shape_operator;
};

/// Makes the entry of a vertex of the prepared mesh from the field alone.
inline CurvedVertex curved_vertex(const PreparedMesh& mesh, const Field& field, std::uint32_t v) {
    const std::uint32_t original = mesh.original_vertex[v];
    const Eigen::Vector3f& n = field.normals[original];
    const TangentFrame frame = tangent_frame(n);
    const ShapeOperator& s = field.shape_operators[original];
    SymmetricTensor local = {s.xx, s.yy, s.zz, s.yz, s.xz, s.xy};
    local.scale(mesh.diagonal);
    return {n.cast<double>(), frame.u.cast<double>(), frame.v.cast<double>(), local};
}

}  // namespace laplacian_lines
