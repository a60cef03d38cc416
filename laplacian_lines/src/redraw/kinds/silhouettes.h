// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clusters/local_eye.h"
#include "fixed/edge_chains.h"
#include "laplacian_lines/line_style.h"
#include "system/on_demand.h"

namespace laplacian_lines {

/// Memory of append_silhouettes(); keeps its capacity.
struct SilhouetteMemory {
    std::vector<float> facing;  ///< by triangle
    CollectedEdges edges;
    TracingMemory tracing;
};

/// Contours of a style that wants them along edges of the mesh, between a triangle that faces the
/// eye and one that does not: the outline of the mesh itself, where contours of interpolated
/// normals are smooth curves across triangles. Nothing in other styles.
void append_silhouettes(const ExtractorData& data, OnDemand<MeshEdges>& mesh_edges,
                        const LocalEye& eye, const LineStyle& style, SilhouetteMemory& memory,
                        LineSet& lines);

}  // namespace laplacian_lines
