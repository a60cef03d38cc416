// SPDX-License-Identifier: GPL-3.0-or-later
// Chains of edges where the surface ends.
#include <algorithm>
#include <vector>

#include "fixed/fixed_lines.h"
#include "fixed/line_copies.h"
#include "fixed/piece_graph.h"
#include "fixed/surface.h"
#include "rules/thresholds.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

constexpr float kPinhole = 3;  // shortest lines around a hole that is worth a border

/// One for each edge, in their order.
std::vector<std::uint32_t> border_sides(const Surface& surface) {
    const auto find = [&](std::uint32_t side, std::vector<std::uint32_t>& found) {
        if (!surface.sides().has_neighbour(side)) found.push_back(side);
    };
    auto sides = collect<std::uint32_t>(surface.sides().side_count(), find);
    const auto edge = [&](std::uint32_t side) {
        return edge_between(surface.begin(side), surface.end(side));
    };
    std::stable_sort(sides.begin(), sides.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return edge(a) < edge(b); });
    const auto last =
        std::unique(sides.begin(), sides.end(),
                    [&](std::uint32_t a, std::uint32_t b) { return edge(a) == edge(b); });
    sides.erase(last, sides.end());
    return sides;
}

LineSet find_borders(const ExtractorData& data, FixedLines& all) {
    LineSet lines;
    if (data.is_body) return lines;  // closed
    const std::shared_ptr<const Surface> shared = all.surface(data);
    const Surface& surface = *shared;
    PieceGraph graph;
    std::vector<std::uint32_t> vertices;  // by node
    const auto node = [&](std::uint32_t vertex) {
        const std::uint32_t number = graph.node(vertex);
        if (number == vertices.size()) vertices.push_back(vertex);
        return number;
    };
    for (const std::uint32_t side : border_sides(surface)) {
        const std::uint32_t begin = node(surface.begin(side));
        graph.add(begin, node(surface.end(side)));
    }
    for (const PieceGraph::Line& line : graph.lines())
        append_line(
            data, LineKind::Border, line,
            [&](std::uint32_t n) { return surface.position(vertices[n]); }, lines);
    return lines;
}

class Borders : public FixedKindLines {
public:
    Borders(const ExtractorData& data, FixedLines& all) : found_(find_borders(data, all)) {}

    void append(const ExtractorData&, FixedLines&, const LocalEye&, const LineStyle& style,
                LineSet& lines) const override {
        const float shortest = kPinhole * Thresholds(style).shortest_line;
        for (const Polyline& line : found_.lines)
            if (line.length >= shortest) append_whole(found_, line, lines);
    }

private:
    const LineSet found_;
};

}  // namespace

const FixedKind kBorders = fixed_kind<Borders>(LineKind::Border);

}  // namespace laplacian_lines
