// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/zero_lines.h"

#include <algorithm>

#include "fixed/piece_graph.h"

namespace laplacian_lines {

ZeroLines trace_zeros(const ExtractorData& data, LineKind kind, float least_length,
                      const std::vector<ZeroPieces>& pieces) {
    PieceGraph graph;
    std::vector<ZeroLines::Sample> samples;  // by node
    const auto node = [&](const Zero& zero) {
        const auto [number, is_new] = graph.node(zero.edge);
        if (is_new) samples.push_back(zero.sample);
        ZeroLines::Sample& sample = samples[number];
        sample.triangle = std::min(sample.triangle, zero.sample.triangle);
        sample.height = std::max(sample.height, zero.sample.height);
        return number;
    };
    for (const ZeroPieces& of_cluster : pieces)
        for (const auto& [begin, end] : of_cluster) {
            const std::uint32_t first = node(begin);
            graph.add(first, node(end));
        }
    ZeroLines found;
    for (const PieceGraph::Line& line : graph.lines()) {
        const Polyline& traced = append_line(
            data, kind, line,
            [&](std::uint32_t n) -> const Eigen::Vector3f& { return samples[n].position; },
            found.lines);
        if (traced.length < least_length) {
            found.lines.points.resize(traced.first);
            found.lines.lines.pop_back();
            continue;
        }
        for (const std::uint32_t n : line.nodes)
            found.samples.push_back(samples[n]);
    }
    return found;
}

}  // namespace laplacian_lines
