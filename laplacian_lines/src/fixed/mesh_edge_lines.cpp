// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/mesh_edge_lines.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace laplacian_lines {
namespace {

constexpr float kDegrees = 57.29577951308232f;

/// Collects edges of the mesh as segments between their vertices, each vertex once.
class EdgeCollector {
public:
    EdgeCollector(const MeshEdges& mesh, CollectedEdges& collected)
        : mesh_(mesh), collected_(collected) {
        std::vector<std::uint32_t>& crossings = collected.crossing_of_vertex;
        if (collected.in_use) crossings.clear();
        if (crossings.size() < mesh.positions.size())
            crossings.resize(mesh.positions.size(), MeshEdges::kNone);
        collected.in_use = true;
        collected.vertex_of_crossing.clear();
        collected.graph.crossings.clear();
        collected.graph.segments.clear();
    }

    void add(const MeshEdges::Edge& edge, float value) {
        collected_.graph.segments.push_back(
            {point(edge.vertices[0], value), point(edge.vertices[1], value), 0});
    }

    /// The edges that were added.
    const CrossingGraph& finish() {
        for (std::uint32_t vertex : collected_.vertex_of_crossing)
            collected_.crossing_of_vertex[vertex] = MeshEdges::kNone;
        collected_.in_use = false;
        return collected_.graph;
    }

private:
    std::uint32_t point(std::uint32_t vertex, float value) {
        std::vector<Crossing>& crossings = collected_.graph.crossings;
        std::uint32_t& index = collected_.crossing_of_vertex[vertex];
        if (index == MeshEdges::kNone) {
            index = std::uint32_t(crossings.size());
            crossings.push_back({mesh_.positions[vertex], 0, 1});
            collected_.vertex_of_crossing.push_back(vertex);
        }
        crossings[index].gradient = std::max(crossings[index].gradient, value);
        return index;
    }

    const MeshEdges& mesh_;
    CollectedEdges& collected_;
};

LineSet trace_all(const ExtractorData& data, LineKind kind, const CrossingGraph& graph) {
    LineRules rules;
    rules.kind = kind;
    TracingMemory memory;
    LineSet lines;
    trace_polylines(data, rules, graph, memory, lines);
    return lines;
}

/// `angle_of(edge)` is the value of an edge, negative for one that is left out.
template <class AngleOf>
LineSet collect(const ExtractorData& data, const MeshEdges& mesh, LineKind kind, AngleOf angle_of) {
    CollectedEdges collected;
    EdgeCollector collector(mesh, collected);
    for (const MeshEdges::Edge& edge : mesh.edges)
        if (const float angle = angle_of(edge); angle >= 0) collector.add(edge, angle);
    return trace_all(data, kind, collector.finish());
}

/// A side of a triangle where the surface ends.
struct BorderSide {
    std::uint32_t vertices[2];  ///< from one to the other
    const float* positions[2];

    std::pair<std::uint32_t, std::uint32_t> edge() const {
        return std::minmax(vertices[0], vertices[1]);
    }
};

/// By edge. Those of one edge, where more than two triangles meet, are in the order of the
/// clusters.
std::vector<BorderSide> border_sides(const ExtractorData& data) {
    std::vector<BorderSide> sides;
    for (const PlacedCluster& placed : place_clusters(data))
        for (unsigned t = 0; t < placed.cluster->triangle_count; ++t)
            for (unsigned k = 0; k < 3; ++k) {
                const ClusterTriangle& triangle = placed.triangles[t];
                if (triangle.neighbours[k] != kNoNeighbour) continue;
                const unsigned a = triangle.corners[k], b = triangle.corners[(k + 1) % 3];
                sides.push_back({{placed.vertices[a], placed.vertices[b]},
                                 {placed.records[a].position, placed.records[b].position}});
            }
    std::stable_sort(sides.begin(), sides.end(),
                     [](const BorderSide& x, const BorderSide& y) { return x.edge() < y.edge(); });
    return sides;
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

LineSet find_borders(const ExtractorData& data) {
    CrossingGraph graph;
    std::unordered_map<std::uint32_t, std::uint32_t> point_of_vertex;
    const auto point = [&](std::uint32_t vertex, const float* position) {
        const auto number = std::uint32_t(graph.crossings.size());
        const auto [place, is_new] = point_of_vertex.try_emplace(vertex, number);
        if (is_new) graph.crossings.push_back({Eigen::Map<const Eigen::Vector3f>(position), 0, 1});
        return place->second;
    };
    const std::vector<BorderSide> sides = border_sides(data);
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const BorderSide& side = sides[i];
        if (i + 1 < sides.size() && side.edge() == sides[i + 1].edge()) continue;
        const std::uint32_t begin = point(side.vertices[0], side.positions[0]);
        graph.segments.push_back({begin, point(side.vertices[1], side.positions[1]), 0});
    }
    return trace_all(data, LineKind::Border, graph);
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
    EdgeCollector collector(mesh, memory.edges);
    const std::uint8_t* faces_away = memory.faces_away.data();
    for (const MeshEdges::Edge& edge : mesh.edges)
        if (!edge.is_border() && faces_away[edge.triangles[0]] != faces_away[edge.triangles[1]])
            collector.add(edge, 0);
    trace_polylines(data, rules, collector.finish(), tracing, lines);
}

}  // namespace laplacian_lines
