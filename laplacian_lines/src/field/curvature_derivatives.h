// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/field.h"
#include "mesh/prepared_mesh.h"
#include "mesh/vertex_ranges.h"
#include "system/parallel.h"

namespace laplacian_lines {

/// Fills Field::curvature_derivatives from the field's normals and shape operators alone, whether
/// they have just been computed or come from elsewhere: the same bits. `mesh` is sorted in space.
void fill_curvature_derivatives(const PreparedMesh& mesh, const VertexRanges& ranges,
                                const StageProgress& stage, Field& field);

}  // namespace laplacian_lines
