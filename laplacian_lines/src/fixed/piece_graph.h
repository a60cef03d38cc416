// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "clusters/extractor_data.h"
#include "laplacian_lines/line_set.h"
#include "system/three_floats.h"

namespace laplacian_lines {

/// Joins unordered pieces to lines. Each piece goes from one node to another: a vertex of the mesh,
/// a zero on an edge, or a place in a picture where visible pieces end.
class PieceGraph {
public:
    /// The number of the node with this key, and whether it is new: the next number.
    std::pair<std::uint32_t, bool> node(std::uint64_t key) {
        const auto [place, is_new] = numbers_.try_emplace(key, std::uint32_t(at_.size()));
        if (is_new) add_node();
        return {place->second, is_new};
    }
    std::uint32_t add_node() {
        at_.emplace_back();
        return std::uint32_t(at_.size() - 1);
    }
    std::uint32_t pieces_at(std::uint32_t node) const { return at_[node].count; }

    void add(std::uint32_t begin, std::uint32_t end) {
        for (const std::uint32_t node : {begin, end}) {
            ++at_[node].count;
            at_[node].ends ^= std::uint32_t(ends_.size());
            ends_.push_back(node);
        }
    }

    /// A sequence of nodes; piece i is between nodes i and i + 1.
    struct Line {
        std::vector<std::uint32_t> nodes, pieces;
        bool is_closed;  ///< the last node is the first again
    };
    /// Lines end at nodes where other than two pieces meet. Of its two ends a line begins at one
    /// where its piece begins, if there is one; closed lines come last.
    std::vector<Line> lines() const;
    /// By line, the number of its net: a node of it, the same for all lines that are connected.
    std::vector<std::uint32_t> nets(const std::vector<Line>& lines) const;

private:
    struct Meeting {
        std::uint32_t count = 0;
        std::uint32_t ends = 0;  // XOR of the ends: of two, either gives the other
    };
    std::unordered_map<std::uint64_t, std::uint32_t> numbers_;  // by key
    std::vector<Meeting> at_;                                   // by node
    std::vector<std::uint32_t> ends_;  // 2 p and 2 p + 1 are the nodes of piece p
};

/// Appends a line to `lines`, of length in D, without smoothing. `position_of(node)`: local.
template <class PositionOf>
Polyline& append_line(const ExtractorData& data, LineKind kind, const PieceGraph::Line& line,
                      PositionOf position_of, LineSet& lines) {
    Polyline appended;
    appended.kind = kind;
    appended.closed = line.is_closed;
    appended.first = std::uint32_t(lines.points.size());
    appended.count = std::uint32_t(line.nodes.size());
    for (std::size_t i = 0; i < line.nodes.size(); ++i) {
        const Eigen::Vector3f here = position_of(line.nodes[i]);
        lines.points.push_back({data.in_line_set(here), 1, 0, 1});
        if (i > 0) appended.length += length_of(here - position_of(line.nodes[i - 1]));
    }
    lines.lines.push_back(appended);
    return lines.lines.back();
}

}  // namespace laplacian_lines
