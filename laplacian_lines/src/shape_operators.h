// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "parallel.h"
#include "prepared_mesh.h"
#include "spatial_tree.h"

namespace laplacian_lines {

/// Shape operators of all vertices, [N], local units, by the curvature tensor of each triangle:
/// S. Rusinkiewicz, "Estimating Curvatures and Their Derivatives on Triangle Meshes", 3DPVT 2004.
std::vector<Eigen::Matrix3d> fit_triangles(const PreparedMesh& mesh,
                                           const std::vector<Eigen::Vector3d>& normals);

/// Shape operators by least squares over the vertices within `radius` (the paper's Eq. 3). Deviates
/// from the paper in two points: solved in the tangent plane, because the 3x3 system's normal
/// component takes up second-order terms (100 % error), and for S instead of ∇I, which is linear
/// in the eye. Where the ball holds too few vertices, `fallback` is kept.
std::vector<Eigen::Matrix3d> fit_balls(const PreparedMesh& mesh, const SpatialTree& tree,
                                       const std::vector<Eigen::Vector3d>& normals, double radius,
                                       bool same_side, const std::vector<Eigen::Matrix3d>& fallback,
                                       const StageProgress& stage);

/// One pass of averaging S over one-rings, each neighbour's tensor projected on the tangent plane.
void smooth_over_one_rings(const PreparedMesh& mesh, const std::vector<Eigen::Vector3d>& normals,
                           std::vector<Eigen::Matrix3d>& operators);

}  // namespace laplacian_lines
