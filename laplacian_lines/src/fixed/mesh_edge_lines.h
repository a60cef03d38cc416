// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clusters/local_eye.h"
#include "fixed/mesh_edges.h"
#include "fixed/segment_tracing.h"
#include "laplacian_lines/line_set.h"

namespace laplacian_lines {

/// Chains of edges where the surface ends.
LineSet find_borders(const ExtractorData& data);

/// Less is not called a crease, whatever the style asks for.
constexpr float kLeastCreaseAngle = 20;  // degrees

/// Chains of edges whose triangles meet at kLeastCreaseAngle or more between their normals. A
/// point's `gradient` is the largest such angle at its vertex, in degrees.
LineSet find_creases(const ExtractorData& data, const MeshEdges& mesh);

/// Edges of the mesh as segments between their vertices; keeps its capacity.
struct CollectedEdges {
    CrossingGraph graph;
    std::vector<std::uint32_t> vertex_of_crossing;
    /// By vertex; kNone everywhere between uses, so that a use costs what its lines cost.
    std::vector<std::uint32_t> crossing_of_vertex;
    bool in_use = false;  ///< an exception left crossing_of_vertex behind
};

/// Memory of append_silhouettes(); keeps its capacity.
struct SilhouetteMemory {
    std::vector<std::uint8_t> faces_away;  ///< by triangle
    CollectedEdges edges;
};

/// Chains of edges between a triangle that faces the eye and one that does not: the outline of the
/// mesh itself, where contours of interpolated normals are smooth curves across triangles.
void append_silhouettes(const ExtractorData& data, const MeshEdges& mesh, const LocalEye& eye,
                        const LineRules& rules, SilhouetteMemory& memory, TracingMemory& tracing,
                        LineSet& lines);

}  // namespace laplacian_lines
