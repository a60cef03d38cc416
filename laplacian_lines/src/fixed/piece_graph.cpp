// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/piece_graph.h"

#include "system/chains.h"
#include "system/disjoint_sets.h"

namespace laplacian_lines {

std::vector<PieceGraph::Line> PieceGraph::lines() const {
    const auto link = [&](std::uint32_t end) {
        const Meeting& here = at_[ends_[end]];
        return here.count == 2 ? here.ends ^ end : kNoEnd;
    };
    const auto pieces = std::uint32_t(ends_.size() / 2);
    std::vector<bool> is_visited(pieces);
    std::vector<Line> lines;
    for_each_chain(pieces, link, [&](std::uint32_t start) {
        if (is_visited[start / 2]) return;
        Line line{{ends_[start]}, {}, false};
        line.is_closed = follow_chain(start, link, [&](std::uint32_t end) {
            is_visited[end / 2] = true;
            line.pieces.push_back(end / 2);
            line.nodes.push_back(ends_[end ^ 1]);
        });
        lines.push_back(std::move(line));
    });
    return lines;
}

std::vector<std::uint32_t> PieceGraph::nets(const std::vector<Line>& lines) const {
    DisjointSets nodes(at_.size());
    for (const Line& line : lines)
        nodes.unite(line.nodes.front(), line.nodes.back());
    std::vector<std::uint32_t> nets;
    for (const Line& line : lines)
        nets.push_back(nodes.root(line.nodes[0]));
    return nets;
}

}  // namespace laplacian_lines
