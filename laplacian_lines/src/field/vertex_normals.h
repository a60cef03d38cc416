// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laplacian_lines/precompute_options.h"
#include "mesh/vertex_ranges.h"

namespace laplacian_lines {

/// Unit vertex normals as the weighted mean of the incident triangles' normals, [N].
/// Max: N. Max, "Weights for Computing Vertex Normals from Facet Normals", J. Graphics Tools 1999.
std::vector<Eigen::Vector3d> vertex_normals(const PreparedMesh& mesh, const VertexRanges& ranges,
                                            NormalWeighting weighting, const StageProgress& stage);

}  // namespace laplacian_lines
