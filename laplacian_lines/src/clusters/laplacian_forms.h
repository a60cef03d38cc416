// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "clusters/cluster_data.h"
#include "laplacian_lines/field.h"
#include "mesh/prepared_mesh.h"

namespace laplacian_lines {

struct ExtractorData;

/// The linear forms Δn·(e − w p) of the vertices of all clusters: all of a mesh that a redraw reads
/// and that depends on the kernel.
struct LaplacianForms {
    std::vector<FormGroup> groups;  ///< cluster by cluster
    float kernel_size = 0;          ///< √h, D
    /// What Δn is multiplied by, so that the slope_scale of the vertices' records, which is of
    /// the kernel of derivatives, gives the slopes of this one. Moves no zeros.
    float factor = 1;

    std::size_t memory() const { return groups.capacity() * sizeof(FormGroup); }  ///< bytes
};

/// h_e of the whole mesh for a √h, D².
double squared_scale(double kernel_size, const FieldScale& scale);

/// Those of the clusters' mesh from a field of it.
LaplacianForms laplacian_forms(const PreparedMesh& mesh, const Field& field,
                               const ExtractorData& data);

}  // namespace laplacian_lines
