// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "clusters/extractor_data.h"
#include "mesh/edge_topology.h"

namespace laplacian_lines {

/// The mesh in one piece, for what is found once; rebuilt from the clusters, so that it need not be
/// kept. Local coordinates.
struct WholeMesh {
    std::vector<Eigen::Vector3f> positions;
    std::vector<Triangle> triangles;
    EdgeTopology topology;
};

WholeMesh rebuild_mesh(const ExtractorData& data);

}  // namespace laplacian_lines
