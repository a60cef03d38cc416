// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "field/field_steps.h"

namespace laplacian_lines {
namespace {

constexpr std::size_t kMostSamples = 20000;
constexpr double kLargestBump = 0.3;  // in mean edges of the vertex; more is an edge of the form
// Lower quartile of the difference between bumps and those around them on a fine flat mesh, over
// the length by which its vertices are moved in random directions.
constexpr double kOfUnitNoise = 0.29;
// Correlation of a bump with the mean of those around it. Forms have 0.5 to 0.9, strongly decimated
// ones 0.3, noise of 20 % of the edges -0.2 to 0.1.
constexpr double kOfForm = 0.45, kOfNoise = 0.15;

/// For each vertex v, the mean of value_of(v, other) over its edges, inner ones once per triangle.
template <class ValueOf>
std::vector<double> mean_over_edges(const PreparedMesh& mesh, const VertexRanges& ranges,
                                    const StageProgress& stage, ValueOf value_of) {
    std::vector<double> means(mesh.size(), 0);
    std::vector<int> counts(mesh.size(), 0);
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

}  // namespace

double vertex_noise(const PreparedMesh& mesh, const VertexRanges& ranges,
                    const std::vector<Eigen::Vector3d>& normals, const StageProgress& stage) {
    const auto edge = [&](std::uint32_t v, std::uint32_t other) -> Eigen::Vector3d {
        return mesh.positions[other] - mesh.positions[v];
    };
    const std::vector<double> edges = mean_over_edges(
        mesh, ranges, stage.part(0, 0.3),
        [&](std::uint32_t v, std::uint32_t other) { return edge(v, other).norm(); });
    const std::vector<double> bumps = mean_over_edges(
        mesh, ranges, stage.part(0.3, 0.7),
        [&](std::uint32_t v, std::uint32_t other) { return normals[v].dot(edge(v, other)); });
    const std::vector<double> around =
        mean_over_edges(mesh, ranges, stage.part(0.7, 1),
                        [&](std::uint32_t, std::uint32_t other) { return bumps[other]; });
    double products = 0, squares = 0;
    std::vector<double> differences;
    const std::size_t step = mesh.size() / kMostSamples + 1;
    for (std::size_t v = 0; v < mesh.size(); v += step) {
        differences.push_back(std::abs(bumps[v] - around[v]) / edges[v]);
        const double bump = std::clamp(bumps[v] / edges[v], -kLargestBump, kLargestBump);
        products += bump * std::clamp(around[v] / edges[v], -kLargestBump, kLargestBump);
        squares += bump * bump;
    }
    if (!(squares > 0)) return 0;
    const auto quartile = differences.begin() + std::ptrdiff_t(differences.size() / 4);
    std::nth_element(differences.begin(), quartile, differences.end());
    const double share = (kOfForm - products / squares) / (kOfForm - kOfNoise);
    return *quartile / kOfUnitNoise * std::clamp(share, 0., 1.);
}

}  // namespace laplacian_lines
