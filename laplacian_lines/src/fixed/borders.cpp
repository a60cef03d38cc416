// SPDX-License-Identifier: GPL-3.0-or-later
// Chains of edges where the surface ends.
#include <algorithm>
#include <unordered_map>
#include <utility>
#include <vector>

#include "fixed/crossing_graph.h"
#include "fixed/fixed_kinds.h"
#include "fixed/segment_tracing.h"
#include "fixed/showing.h"

namespace laplacian_lines {
namespace {

constexpr float kPinhole = 3;  // shortest lines around a hole that is worth a border

/// A side of a triangle where the surface ends.
struct BorderSide {
    std::uint32_t vertices[2];  ///< from one to the other
    const float* positions[2];

    std::pair<std::uint32_t, std::uint32_t> edge() const {
        return std::minmax(vertices[0], vertices[1]);
    }
};

/// By edge; those of one edge, where more than two triangles meet, by cluster.
std::vector<BorderSide> border_sides(const ExtractorData& data) {
    std::vector<BorderSide> sides;
    for (const PlacedCluster& placed : place_clusters(data))
        for (unsigned t = 0; t < placed.cluster->triangle_count; ++t)
            for (unsigned k = 0; k < 3; ++k) {
                const ClusterTriangle& triangle = placed.triangle(t);
                if (triangle.neighbours[k] != kNoNeighbour) continue;
                const unsigned a = triangle.corners[k], b = triangle.corners[(k + 1) % 3];
                sides.push_back({{placed.vertices[a], placed.vertices[b]},
                                 {placed.records[a].position, placed.records[b].position}});
            }
    std::stable_sort(sides.begin(), sides.end(),
                     [](const BorderSide& x, const BorderSide& y) { return x.edge() < y.edge(); });
    return sides;
}

LineSet find_borders(const ExtractorData& data) {
    CrossingGraph graph;
    std::unordered_map<std::uint32_t, std::uint32_t> point_of_vertex;
    const auto point = [&](std::uint32_t vertex, const float* position) {
        const auto number = std::uint32_t(graph.crossings.size());
        const auto [place, is_new] = point_of_vertex.try_emplace(vertex, number);
        if (is_new) graph.crossings.push_back({Eigen::Map<const Eigen::Vector3f>(position), 0});
        return place->second;
    };
    const std::vector<BorderSide> sides = border_sides(data);
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const BorderSide& side = sides[i];
        if (i + 1 < sides.size() && side.edge() == sides[i + 1].edge()) continue;
        const std::uint32_t begin = point(side.vertices[0], side.positions[0]);
        graph.segments.push_back({begin, point(side.vertices[1], side.positions[1])});
    }
    LineRules rules;
    rules.kind = LineKind::Border;
    TracingMemory memory;
    LineSet lines;
    trace_segments(data, rules, graph, memory, lines);
    return lines;
}

class Borders : public FixedKindLines {
public:
    explicit Borders(const ExtractorData& data) : lines_(find_borders(data)) {}

    void append(const ExtractorData&, FixedLines&, const LocalEye&, const LineStyle& style,
                LineSet& lines) const override {
        append_lines(
            lines_, {kPinhole * Thresholds(style).shortest_line, 0},
            [](std::size_t) { return true; }, [](std::size_t) { return 1.f; }, lines);
    }

private:
    const LineSet lines_;
};

}  // namespace

const FixedKind borders = fixed_kind<Borders>(LineKind::Border);

}  // namespace laplacian_lines
