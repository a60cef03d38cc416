// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "field/cubic_form.h"
#include "field/symmetric_tensor.h"
#include "laplacian_lines/field.h"
#include "laplacian_lines/tangent_frame.h"
#include "mesh/prepared_mesh.h"
#include "mesh/vertex_ranges.h"
#include "system/parallel.h"

namespace laplacian_lines {

/// A vertex whose S is differentiated, local units.
struct CurvedVertex {
    Eigen::Vector3d normal, u, v;  ///< orthonormal
    SymmetricTensor shape_operator;
};

inline CurvedVertex curved_vertex(const PreparedMesh& mesh, const Field& field, std::uint32_t v) {
    const std::uint32_t original = mesh.original_vertex[v];
    const Eigen::Vector3f& n = field.normals[original];
    const TangentFrame frame = tangent_frame(n);
    const ShapeOperator& s = field.shape_operators[original];
    SymmetricTensor local = {s.xx, s.yy, s.zz, s.yz, s.xz, s.xy};
    local.scale(mesh.diagonal);
    return {n.cast<double>(), frame.u.cast<double>(), frame.v.cast<double>(), local};
}

/// Sets the derivative of S of the `wanted` vertices, [N], in the frames of curved_vertex(), by
/// differences within the triangles at each: S is linear between corners, in the triangle's plane,
/// and the result is made symmetric, as on smooth surfaces (Codazzi). S. Rusinkiewicz, "Estimating
/// Curvatures and Their Derivatives on Triangle Meshes", 3DPVT 2004, section 4, without least
/// squares. 0 where no triangle faces as its corners do.
void set_ring_derivatives(const PreparedMesh& mesh, const VertexRanges& ranges, const Field& field,
                          const std::vector<std::uint8_t>& wanted, std::vector<CubicForm>& forms);

}  // namespace laplacian_lines
