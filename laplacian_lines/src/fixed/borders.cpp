// SPDX-License-Identifier: GPL-3.0-or-later
// Chains of edges where the surface ends.
#include <algorithm>
#include <utility>
#include <vector>

#include "fixed/fixed_lines.h"
#include "fixed/piece_graph.h"
#include "rules/thresholds.h"

namespace laplacian_lines {
namespace {

constexpr float kPinhole = 3;  // shortest lines around a hole that is worth a border

/// A side of a triangle where the surface ends.
struct BorderSide {
    std::uint32_t vertices[2];  ///< from one to the other
    Eigen::Vector3f positions[2];

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
                                 {position_of(placed.records[a]), position_of(placed.records[b])}});
            }
    std::stable_sort(sides.begin(), sides.end(),
                     [](const BorderSide& x, const BorderSide& y) { return x.edge() < y.edge(); });
    return sides;
}

LineSet find_borders(const ExtractorData& data) {
    PieceGraph graph;
    std::vector<Eigen::Vector3f> positions;  // by node
    const auto node = [&](const BorderSide& side, int end) {
        const std::uint32_t number = graph.node(side.vertices[end]);
        if (number == positions.size()) positions.push_back(side.positions[end]);
        return number;
    };
    const std::vector<BorderSide> sides = border_sides(data);
    for (std::size_t i = 0; i < sides.size(); ++i) {
        if (i + 1 < sides.size() && sides[i].edge() == sides[i + 1].edge()) continue;
        const std::uint32_t begin = node(sides[i], 0);
        graph.add(begin, node(sides[i], 1));
    }
    LineSet lines;
    for (const PieceGraph::Line& line : graph.lines())
        append_line(
            data, LineKind::Border, line,
            [&](std::uint32_t n) -> const Eigen::Vector3f& { return positions[n]; }, lines);
    return lines;
}

class Borders : public FixedKindLines {
public:
    explicit Borders(const ExtractorData& data) : found_(find_borders(data)) {}

    void append(const ExtractorData&, FixedLines&, const LocalEye&, const LineStyle& style,
                LineSet& lines) const override {
        const float shortest = kPinhole * Thresholds(style).shortest_line;
        for (Polyline line : found_.lines) {
            if (line.length < shortest) continue;
            const auto begin = found_.points.begin() + line.first;
            line.first = std::uint32_t(lines.points.size());
            lines.points.insert(lines.points.end(), begin, begin + line.count);
            lines.lines.push_back(line);
        }
    }

private:
    const LineSet found_;
};

}  // namespace

const FixedKind borders = fixed_kind<Borders>(LineKind::Border);

}  // namespace laplacian_lines
