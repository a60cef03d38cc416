// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "clusters/extractor_data.h"
#include "mesh/prepared_mesh.h"

namespace laplacian_lines {

/// Those of the vertices of the clusters, which are of this mesh, from a field with derivatives.
std::vector<CurvatureRecord> curvature_records(const PreparedMesh& mesh, const Field& field,
                                               const ExtractorData& data);

}  // namespace laplacian_lines
