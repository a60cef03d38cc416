// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_edge_lines.h"

#include <algorithm>
#include <cmath>

namespace laplacian_lines {
namespace {

constexpr float kDegrees = 57.29577951308232f;

/// Collects edges of the mesh as segments between their vertices, each vertex once.
class EdgeCollector {
public:
    EdgeCollector(const MeshEdges& mesh, std::vector<std::uint32_t>& point_of_vertex,
                  CrossingGraph& graph)
        : mesh_(mesh), point_of_vertex_(point_of_vertex), graph_(graph) {
        point_of_vertex_.assign(mesh.positions.size(), MeshEdges::kNone);
        graph_.crossings.clear();
        graph_.segments.clear();
    }

    void add(const MeshEdges::Edge& edge, float value) {
        graph_.segments.push_back(
            {point(edge.vertices[0], value), point(edge.vertices[1], value), 0});
    }

private:
    std::uint32_t point(std::uint32_t vertex, float value) {
        std::uint32_t& index = point_of_vertex_[vertex];
        if (index == MeshEdges::kNone) {
            index = std::uint32_t(graph_.crossings.size());
            graph_.crossings.push_back({mesh_.positions[vertex], 0, 1});
        }
        float& gradient = graph_.crossings[index].gradient;
        gradient = std::max(gradient, value);
        return index;
    }

    const MeshEdges& mesh_;
    std::vector<std::uint32_t>& point_of_vertex_;
    CrossingGraph& graph_;
};

/// `angle_of(edge)` is the value of an edge, negative for one that is left out.
template <class AngleOf>
LineSet collect(const ExtractorData& data, const MeshEdges& mesh, LineKind kind, AngleOf angle_of) {
    std::vector<std::uint32_t> point_of_vertex;
    CrossingGraph graph;
    EdgeCollector collector(mesh, point_of_vertex, graph);
    for (const MeshEdges::Edge& edge : mesh.edges)
        if (const float angle = angle_of(edge); angle >= 0) collector.add(edge, angle);
    LineRules rules;
    rules.kind = kind;
    TracingMemory memory;
    LineSet lines;
    trace_polylines(data, rules, graph, memory, lines);
    return lines;
}

Eigen::Vector3f normal(const MeshEdges& mesh, std::uint32_t triangle) {
    const Planes& planes = mesh.planes;
    return {planes.x[triangle], planes.y[triangle], planes.z[triangle]};
}

void find_faces_away(const Planes& planes, const LocalEye& eye,
                     std::vector<std::uint8_t>& faces_away) {
    const float ex = eye.eye.x(), ey = eye.eye.y(), ez = eye.eye.z(), w = eye.w;
    faces_away.resize(planes.x.size());
    for (std::size_t i = 0; i < faces_away.size(); ++i)
        faces_away[i] =
            planes.x[i] * ex + planes.y[i] * ey + planes.z[i] * ez < w * planes.offset[i];
}

}  // namespace

LineSet find_borders(const ExtractorData& data, const MeshEdges& mesh) {
    return collect(data, mesh, LineKind::Border,
                   [](const MeshEdges::Edge& edge) { return edge.is_border() ? 0.f : -1.f; });
}

LineSet find_creases(const ExtractorData& data, const MeshEdges& mesh) {
    return collect(data, mesh, LineKind::Crease, [&](const MeshEdges::Edge& edge) {
        if (edge.is_border()) return -1.f;
        const float cosine = normal(mesh, edge.triangles[0]).dot(normal(mesh, edge.triangles[1]));
        const float angle = std::acos(std::clamp(cosine, -1.f, 1.f)) * kDegrees;
        return angle >= kLeastCreaseAngle ? angle : -1;
    });
}

void append_silhouettes(const ExtractorData& data, const MeshEdges& mesh, const LocalEye& eye,
                        const LineRules& rules, SilhouetteMemory& memory, TracingMemory& tracing,
                        LineSet& lines) {
    find_faces_away(mesh.planes, eye, memory.faces_away);
    EdgeCollector collector(mesh, memory.point_of_vertex, memory.graph);
    const std::uint8_t* faces_away = memory.faces_away.data();
    for (const MeshEdges::Edge& edge : mesh.edges)
        if (!edge.is_border() && faces_away[edge.triangles[0]] != faces_away[edge.triangles[1]])
            collector.add(edge, 0);
    trace_polylines(data, rules, memory.graph, tracing, lines);
}

}  // namespace laplacian_lines
