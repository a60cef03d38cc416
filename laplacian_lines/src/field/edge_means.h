// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/vertex_ranges.h"

namespace laplacian_lines {

/// For each vertex v that is_asked(v), the mean of value_of(v, other) over its edges, inner ones
/// once per triangle, and of start[v] unless that is empty; start[v] or 0 for others.
template <class IsAsked, class ValueOf>
std::vector<double> mean_over_edges(const PreparedMesh& mesh, const VertexRanges& ranges,
                                    const std::vector<double>& start, const StageProgress& stage,
                                    IsAsked is_asked, ValueOf value_of) {
    std::vector<double> means = start;
    std::vector<int> counts(mesh.size(), start.empty() ? 0 : 1);
    means.resize(mesh.size(), 0);
    ranges.for_each(stage, [&](const VertexRanges::Range& range) {
        const auto add = [&](std::uint32_t at, std::uint32_t other) {
            if (!range.holds(at) || !is_asked(at)) return;
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
            if (counts[v] > 0) means[v] /= counts[v];
    });
    return means;
}

inline constexpr auto kAllVertices = [](std::uint32_t) { return true; };

template <class IsAsked>
std::vector<double> mean_edges(const PreparedMesh& mesh, const VertexRanges& ranges,
                               const StageProgress& stage, IsAsked is_asked) {
    const auto length = [&](std::uint32_t v, std::uint32_t other) {
        return (mesh.positions[other] - mesh.positions[v]).norm();
    };
    return mean_over_edges(mesh, ranges, {}, stage, is_asked, length);
}

}  // namespace laplacian_lines
