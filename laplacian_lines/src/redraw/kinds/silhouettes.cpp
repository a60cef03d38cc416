// SPDX-License-Identifier: GPL-3.0-or-later
#include "redraw/kinds/silhouettes.h"

#include "redraw/kinds/contours.h"

namespace laplacian_lines {
namespace {

void find_faces_away(const Planes& planes, const LocalEye& eye,
                     std::vector<std::uint8_t>& faces_away) {
    const float ex = eye.eye.x(), ey = eye.eye.y(), ez = eye.eye.z(), w = eye.w;
    faces_away.resize(planes.x.size());
    for (std::size_t i = 0; i < faces_away.size(); ++i)
        faces_away[i] =
            planes.x[i] * ex + planes.y[i] * ey + planes.z[i] * ez < w * planes.offset[i];
}

}  // namespace

void append_silhouettes(const ExtractorData& data, OnDemand<MeshEdges>& mesh_edges,
                        const LocalEye& eye, const LineStyle& style, SilhouetteMemory& memory,
                        LineSet& lines) {
    if (!style.shows[LineKind::Contour] || !style.mesh_silhouettes) return;
    const MeshEdges& mesh = mesh_edges.get([&] { return find_mesh_edges(rebuild_mesh(data)); });
    find_faces_away(mesh.planes, eye, memory.faces_away);
    EdgeCollector collector(mesh, memory.edges);
    const std::uint8_t* faces_away = memory.faces_away.data();
    for (const MeshEdges::Edge& edge : mesh.edges)
        if (!edge.is_border() && faces_away[edge.triangles[0]] != faces_away[edge.triangles[1]])
            collector.add(edge, 0);
    LineRules rules = contour_rules(style);
    rules.smoothing_passes = 0;  // exact is what they are for
    trace_segments(data, rules, collector.finish(), memory.tracing, lines);
}

}  // namespace laplacian_lines
