// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "plain_mesh.h"

namespace benchmarks {

/// Curvature of a surface at a vertex and how it changes. Signs as in the core: S = dn, a sphere of
/// radius R with outward normals has the curvatures +1/R.
struct VertexCurvature {
    std::array<Eigen::Vector3f, 2> directions;  ///< principal, unit, tangential
    std::array<float, 2> curvatures;            ///< along them, 1/length
    /// C, the derivative of S along the surface, a symmetric trilinear form in the basis of the
    /// directions: C(1,1,1), C(1,1,2), C(1,2,2), C(2,2,2), in 1/length².
    std::array<float, 4> derivative;
};

/// For each vertex; zeros where no triangle with an area is. `normals` are unit, outward.
/// Source: S. Rusinkiewicz, "Estimating Curvatures and Their Derivatives on Triangle Meshes",
/// 3DPVT 2004: least squares on each triangle, then the mean over the triangles of a vertex,
/// weighted by their Voronoi areas.
std::vector<VertexCurvature> vertex_curvatures(const PlainMesh& mesh,
                                               const std::vector<Eigen::Vector3f>& normals);

}  // namespace benchmarks
