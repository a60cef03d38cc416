// SPDX-License-Identifier: GPL-3.0-or-later
#include "redraw/kinds/silhouettes.h"

#include "redraw/kinds/contours.h"

namespace laplacian_lines {

void append_silhouettes(const ExtractorData& data, OnDemand<MeshEdges>& mesh_edges,
                        const LocalEye& eye, const LineStyle& style, SilhouetteMemory& memory,
                        LineSet& lines) {
    if (!style.shows[LineKind::Contour] || !style.mesh_silhouettes) return;
    const MeshEdges& mesh = mesh_edges.get([&] { return find_mesh_edges(rebuild_mesh(data)); });
    mesh.planes.evaluate(eye, memory.facing);
    EdgeCollector collector(mesh, memory.edges);
    const auto faces_away = [&](std::uint32_t triangle) { return memory.facing[triangle] < 0; };
    for (const MeshEdges::Edge& edge : mesh.edges)
        if (!edge.is_border() && faces_away(edge.triangles[0]) != faces_away(edge.triangles[1]))
            collector.add(edge, 0);
    LineRules rules = contour_rules(style);
    rules.smoothing_passes = 0;  // exact is what they are for
    trace_segments(data, rules, collector.finish(), memory.tracing, lines);
}

}  // namespace laplacian_lines
