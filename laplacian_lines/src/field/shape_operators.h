// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "field/symmetric_tensor.h"
#include "mesh/prepared_mesh.h"
#include "mesh/spatial_tree.h"
#include "mesh/vertex_ranges.h"
#include "system/parallel.h"

namespace laplacian_lines {

/// [N], local units.
using ShapeOperators = std::vector<SymmetricTensor>;

/// By the curvature tensor of each triangle: S. Rusinkiewicz, "Estimating Curvatures and Their
/// Derivatives on Triangle Meshes", 3DPVT 2004.
ShapeOperators fit_triangles(const PreparedMesh& mesh, const VertexRanges& ranges,
                             const std::vector<Eigen::Vector3d>& normals,
                             const StageProgress& stage);

/// Least squares over the vertices within `radius` (the paper's Eq. 3), but solved in the tangent
/// plane, because the 3x3 system's normal component takes up second-order terms (100 % error), and
/// for S instead of ∇I, which is linear in the eye. Keeps `fallback` where the ball holds too few
/// vertices.
ShapeOperators fit_balls(const PreparedMesh& mesh, const SpatialTree& tree,
                         const std::vector<Eigen::Vector3d>& normals, double radius, bool same_side,
                         const ShapeOperators& fallback, const StageProgress& stage);

/// Averages S over one-rings, neighbours projected on the tangent plane.
void smooth_over_one_rings(const PreparedMesh& mesh, const VertexRanges& ranges,
                           const std::vector<Eigen::Vector3d>& normals, int passes,
                           const StageProgress& stage, ShapeOperators& operators);

}  // namespace laplacian_lines
