// SPDX-License-Identifier: GPL-3.0-or-later
// Chains of edges where the surface ends, or several surfaces meet at an angle. Connected chains
// are judged together: each ends where ribs stand on a plate.
#include <algorithm>
#include <vector>

#include "fixed/fixed_lines.h"
#include "fixed/line_copies.h"
#include "fixed/piece_graph.h"
#include "fixed/surface_walk.h"
#include "rules/thresholds.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

// Least length of connected borders, in shortest lines: pinholes have none.
constexpr float kPinhole = 3;

/// Whether some of the triangles at these sides of an edge meet at an angle; copies do not.
template <class Sides>
bool are_bent(const Surface& surface, Sides first, Sides last) {
    const float bent = cosine_of(kEdgeAngle / kDegrees);
    for (; first != last; ++first)
        if (std::any_of(first + 1, last, [&](std::uint32_t side) {
                return std::abs(dot(surface.facet(*first / 3).normal,
                                    surface.facet(side / 3).normal)) < bent;
            }))
            return true;
    return false;
}

/// A side of each border, in the order of edges.
std::vector<std::uint32_t> border_sides(const Surface& surface) {
    // by the table: also beside triangles without an area
    auto open = numbers_where(surface.sides().side_count(), [&](std::uint32_t side) {
        return !surface.sides().has_neighbour(side);
    });
    const auto edge = [&](std::uint32_t side) {
        return edge_between(surface.begin(side), surface.end(side));
    };
    std::stable_sort(open.begin(), open.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return edge(a) < edge(b); });
    std::vector<std::uint32_t> found;
    for (auto first = open.begin(), last = first; first != open.end(); first = last) {
        last =
            std::find_if(first, open.end(), [&](auto side) { return edge(side) != edge(*first); });
        if (last - first == 1 || are_bent(surface, first, last)) found.push_back(*first);
    }
    return found;
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
    for (const std::uint32_t side : border_sides(*surface)) {
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
