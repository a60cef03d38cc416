// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/vertex_ranges.h"

namespace laplacian_lines {

/// For each vertex v, the mean of value_of(v, other) over its edges, inner ones once per triangle,
/// and of start[v] unless that is empty.
template <class ValueOf>
std::vector<double> mean_over_edges(const PreparedMesh& mesh, const VertexRanges& ranges,
                                    const std::vector<double>& start, const StageProgress& stage,
                                    ValueOf value_of) {
    std::vector<double> means = start;
    std::vector<int> counts(mesh.size(), start.empty() ? 0 : 1);
    means.resize(mesh.size(), 0);
    ranges.for_each(stage, [&](const VertexRanges::Range& range) {
        const auto add = [&](std::uint32_t at, std::uint32_t other) {
            if (!range.holds(at)) return;
            means[at] += value_of(at, other);
            ++counts[at];
        };
        range.for_each_triangle([&](const Triangle& t) {
            for (int k = 0; k < 3; ++k) {
                add(t[k], t[(k + 1) % 3]);
                add(t[(k + 1) % 3], t[k]);
            }
        });
        for (std::uint32_t v = range.begin(); v < range.end(); ++v)
            means[v] /= counts[v];
    });
    return means;
}

inline std::vector<double> mean_edges(const PreparedMesh& mesh, const VertexRanges& ranges,
                                      const StageProgress& stage) {
    return mean_over_edges(mesh, ranges, {}, stage, [&](std::uint32_t v, std::uint32_t other) {
        return (mesh.positions[other] - mesh.positions[v]).norm();
    });
}

}  // namespace laplacian_lines
