// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clusters/extractor_data.h"
#include "mesh/prepared_mesh.h"
#include "system/parallel.h"

namespace laplacian_lines {

/// h_e of a whole mesh for a √h in its units, D².
double squared_scale(double kernel_size, const FieldScale& scale);

/// Writes the clusters of a mesh into `data`, whose centre and diagonal are set. The number of
/// threads does not matter.
void build_clusters(const PreparedMesh& mesh, const Field& field, const StageProgress& stage,
                    ExtractorData& data);

}  // namespace laplacian_lines
