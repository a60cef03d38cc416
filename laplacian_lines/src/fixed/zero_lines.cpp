// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/zero_lines.h"

#include <algorithm>
#include <unordered_map>

#include "fixed/segment_tracing.h"

namespace laplacian_lines {
namespace {

/// Joins the pieces at their ends.
class ZeroGraph {
public:
    explicit ZeroGraph(const std::vector<ZeroPieces>& pieces) {
        for (const ZeroPieces& of_cluster : pieces)
            for (const ZeroPiece& piece : of_cluster) {
                const std::uint32_t begin = crossing(piece.ends[0]);
                graph_.segments.push_back({begin, crossing(piece.ends[1])});
            }
    }
    const CrossingGraph& graph() const { return graph_; }
    /// The zero that a traced point comes from. Above 2^24 crossings, one beside it.
    const Zero& zero(const LinePoint& point) const {
        return *zeros_[std::min(std::size_t(point.gradient), zeros_.size() - 1)];
    }

private:
    std::uint32_t crossing(const Zero& zero) {
        const auto number = std::uint32_t(zeros_.size());
        const auto [place, is_new] = crossing_of_edge_.try_emplace(zero.edge, number);
        if (is_new) {
            // Its number travels through the tracing in place of a gradient.
            graph_.crossings.push_back({zero.form.position, float(number)});
            zeros_.push_back(&zero);
        }
        return place->second;
    }

    CrossingGraph graph_;
    std::vector<const Zero*> zeros_;  // by crossing
    std::unordered_map<std::uint64_t, std::uint32_t> crossing_of_edge_;
};

}  // namespace

ZeroLines trace_zeros(const ExtractorData& data, LineKind kind, float least_length,
                      const std::vector<ZeroPieces>& pieces) {
    const ZeroGraph graph(pieces);
    LineRules rules;
    rules.kind = kind;
    rules.least_length = least_length;
    TracingMemory memory;
    ZeroLines found;
    trace_segments(data, rules, graph.graph(), memory, found.lines);
    for (const LinePoint& point : found.lines.points)
        found.forms.push_back(graph.zero(point).form);
    for (Polyline& line : found.lines.lines)
        line.strength = 0;
    return found;
}

}  // namespace laplacian_lines
