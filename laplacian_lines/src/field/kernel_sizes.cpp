// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/field_steps.h"

#include <algorithm>

namespace laplacian_lines {
namespace {

constexpr int kSmoothingPasses = 10;
constexpr double kSmallestRatio = 0.25, kLargestRatio = 4;
// In D. Beyond, nothing changes: no vertex has a neighbour, or all are equally near.
constexpr double kSmallestKernel = 1e-7, kLargestKernel = 1e4;
constexpr double kLargestDrawnKernel = 0.04;

/// For each vertex v, the mean of value_of(v, other) over its edges, inner ones once per triangle,
/// and of start[v] unless that is empty.
template <class Value>
std::vector<double> mean_over_edges(const PreparedMesh& mesh, const VertexRanges& ranges,
                                    const std::vector<double>& start, const StageProgress& stage,
                                    Value value_of) {
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

}  // namespace

double automatic_kernel_size(double mean_edge, double diagonal) {
    return std::max(2 * mean_edge, 0.0045 * diagonal);
}

KernelRange drawn_kernel_range(double mean_edge, double diagonal) {
    return {2 * mean_edge, std::max(2 * mean_edge, kLargestDrawnKernel * diagonal)};
}

double global_kernel_size(const PreparedMesh& mesh, const PrecomputeOptions& options) {
    if (options.drawn_kernel_size > 0) {
        const KernelRange range = drawn_kernel_range(mesh.mean_edge, 1);
        return std::clamp(options.drawn_kernel_size / mesh.diagonal, range.least, range.most);
    }
    return options.kernel_size > 0
               ? std::clamp(options.kernel_size / mesh.diagonal, kSmallestKernel, kLargestKernel)
               : automatic_kernel_size(mesh.mean_edge, 1);
}

std::vector<float> relative_kernel_sizes(const PreparedMesh& mesh, const VertexRanges& ranges,
                                         KernelMode mode, const StageProgress& stage) {
    if (mode == KernelMode::Uniform) return std::vector<float>(mesh.size(), 1.f);
    const auto part = [&](int i) {
        return stage.part(double(i) / (kSmoothingPasses + 1),
                          double(i + 1) / (kSmoothingPasses + 1));
    };
    std::vector<double> lengths =
        mean_over_edges(mesh, ranges, {}, part(0), [&](std::uint32_t v, std::uint32_t other) {
            return (mesh.positions[other] - mesh.positions[v]).norm();
        });
    for (int pass = 0; pass < kSmoothingPasses; ++pass)
        lengths =
            mean_over_edges(mesh, ranges, lengths, part(pass + 1),
                            [&](std::uint32_t, std::uint32_t other) { return lengths[other]; });
    std::vector<float> ratios(mesh.size());
    for (std::size_t v = 0; v < ratios.size(); ++v)
        ratios[v] = float(std::clamp(lengths[v] / mesh.mean_edge, kSmallestRatio, kLargestRatio));
    return ratios;
}

}  // namespace laplacian_lines
