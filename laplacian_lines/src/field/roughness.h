// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "mesh/prepared_mesh.h"
#include "mesh/spatial_tree.h"

namespace laplacian_lines {

/// MeshReport::roughness from vertex normals that nothing has smoothed yet: how much more the
/// normals turn when they are smoothed by 1.6 mean edges instead of 0.8 than by 3.2 instead of 1.6,
/// lower quartiles of a thousand vertices. Smoothing takes noise away at the finest scale, form
/// at the coarsest. It counts less where most normals keep within 2 degrees of their neighbours'
/// mean; 0 where a mesh is too coarse to tell, or has too many vertices near each other. At least 1
/// if has_noisy_facets(). Mean edges are times relative_sizes[v] at each vertex, as those of the
/// smoothing.
double measure_roughness(const PreparedMesh& mesh, const SpatialTree& tree,
                         const std::vector<float>& relative_sizes,
                         const std::vector<Eigen::Vector3d>& normals);

}  // namespace laplacian_lines
