// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "fixed/crossing_graph.h"
#include "fixed/mesh_edges.h"
#include "fixed/segment_tracing.h"

namespace laplacian_lines {

/// Edges of the mesh as segments between their vertices; keeps its capacity.
struct CollectedEdges {
    CrossingGraph graph;
    std::vector<std::uint32_t> vertex_of_crossing;
    /// By vertex; kNone everywhere between uses, so that a use costs what its lines cost.
    std::vector<std::uint32_t> crossing_of_vertex;
    bool in_use = false;  ///< an exception left crossing_of_vertex behind
};

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

    /// `value` becomes the gradient of its points, the largest one where edges meet.
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

/// All lines that the segments make.
inline LineSet trace_all(const ExtractorData& data, LineKind kind, const CrossingGraph& graph) {
    LineRules rules;
    rules.kind = kind;
    TracingMemory memory;
    LineSet lines;
    trace_segments(data, rules, graph, memory, lines);
    return lines;
}

}  // namespace laplacian_lines
