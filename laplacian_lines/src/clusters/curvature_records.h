// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "clusters/extractor_data.h"
#include "mesh/prepared_mesh.h"

namespace laplacian_lines {

constexpr double kLargestCurvature = 1e8;  ///< S·D: floats can take powers of it

/// Within ±limit; what is no number is 0.
inline double bounded(double x, double limit) {
    return std::isnan(x) ? 0 : std::clamp(x, -limit, limit);
}

/// Those of the vertices of the clusters, which are of this mesh, from a field with derivatives.
std::vector<CurvatureRecord> curvature_records(const PreparedMesh& mesh, const Field& field,
                                               const ExtractorData& data);

}  // namespace laplacian_lines
