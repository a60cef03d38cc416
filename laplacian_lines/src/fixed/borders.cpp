// SPDX-License-Identifier: GPL-3.0-or-later
// Chains of edges where the surface ends, or several surfaces meet at an angle. Connected chains
// are judged together, for a chain ends wherever another meets it, as ribs on a plate do.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "fixed/fixed_lines.h"
#include "fixed/line_copies.h"
#include "fixed/piece_graph.h"
#include "fixed/surface_walk.h"
#include "mesh/sides_by_edge.h"
#include "rules/thresholds.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

// Least length of connected borders, in shortest lines: those of pinholes are not drawn.
constexpr float kPinhole = 3;

using Sides = std::vector<std::uint32_t>;

/// Whether some of the triangles at these sides of an edge meet at an angle; copies do not. Planes
/// that are all within 40 degrees of the first differ by the range of their angles to it.
bool are_bent(const Surface& surface, const Sides& sides) {
    const Eigen::Vector3f normal = surface.facet(sides[0] / 3).normal,
                          along = unit(surface.span(sides[0]));
    float least = 0, most = 0;
    for (const std::uint32_t side : sides) {
        const Eigen::Vector3f& other = surface.facet(side / 3).normal;
        const float sine = dot(normal.cross(other), along), cosine = dot(normal, other);
        const float turn = arc_tangent(cosine < 0 ? -sine : sine, std::abs(cosine)) * kDegrees;
        least = std::min(least, turn);
        most = std::max(most, turn);
    }
    return most - least > kEdgeAngle;
}

/// A side of each border, in the order of edges.
Sides border_sides(const Surface& surface, std::size_t vertices) {
    // by the table, where a triangle without an area is a neighbour, too
    const Sides open = numbers_where(surface.sides().side_count(), [&](std::uint32_t side) {
        return !surface.sides().has_neighbour(side);
    });
    const auto edge = [&](std::uint32_t i) {
        return edge_between(surface.begin(open[i]), surface.end(open[i]));
    };
    const auto add = [&](const std::uint32_t* begin, const std::uint32_t* end, Sides& found) {
        Sides sides;
        for (; begin != end; ++begin)
            sides.push_back(open[*begin]);
        if (sides.size() == 1 || are_bent(surface, sides)) found.push_back(sides[0]);
    };
    return concatenate(visit_edges<Sides>(open.size(), vertices, edge, add));
}

struct FoundBorders {
    LineSet lines;
    std::vector<float> lengths;  ///< by line: of all that are connected with it, D
};

FoundBorders find_borders(const ExtractorData& data, FixedLines& all) {
    FoundBorders found;
    if (data.is_body) return found;  // closed
    const auto surface = all.surface(data);
    PieceGraph graph;
    std::vector<std::uint32_t> vertices;  // by node
    const auto node = [&](std::uint32_t vertex) {
        const auto [number, is_new] = graph.node(vertex);
        if (is_new) vertices.push_back(vertex);
        return number;
    };
    for (const std::uint32_t side : border_sides(*surface, data.vertex_count)) {
        const std::uint32_t begin = node(surface->begin(side));
        graph.add(begin, node(surface->end(side)));
    }
    const std::vector<PieceGraph::Line> lines = graph.lines();
    const std::vector<std::uint32_t> net_of = graph.nets(lines);
    std::vector<float> lengths(vertices.size());  // by net
    const auto position_of = [&](std::uint32_t n) { return surface->position(vertices[n]); };
    for (std::size_t i = 0; i < lines.size(); ++i)
        lengths[net_of[i]] +=
            append_line(data, LineKind::Border, lines[i], position_of, found.lines).length;
    for (const std::uint32_t net : net_of)
        found.lengths.push_back(lengths[net]);
    return found;
}

class Borders : public FixedKindLines {
public:
    Borders(const ExtractorData& data, FixedLines& all) : found_(find_borders(data, all)) {}

    void append(const ExtractorData&, FixedLines&, const LocalEye&, const LineStyle& style,
                LineSet& lines) const override {
        const float shortest = kPinhole * Thresholds(style).shortest_line;
        for (std::size_t i = 0; i < found_.lengths.size(); ++i)
            if (found_.lengths[i] >= shortest)
                append_whole(found_.lines, found_.lines.lines[i], lines);
    }

private:
    const FoundBorders found_;
};

}  // namespace

const FixedKind kBorders = fixed_kind<Borders>(LineKind::Border);

}  // namespace laplacian_lines
