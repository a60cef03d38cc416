// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "field/edge_means.h"
#include "field/field_steps.h"

namespace laplacian_lines {
namespace {

constexpr int kSmoothingPasses = 10;
constexpr double kSmallestRatio = 0.25, kLargestRatio = 4;
// In D. Beyond these, nothing changes: no vertex is within the kernel, or all are.
constexpr double kSmallestKernel = 1e-7, kLargestKernel = 1e4;
constexpr double kLargestDrawnKernel = 0.04;  // D
constexpr double kLeastShare = 0.0045;        // D: finer meshes do not get ever finer lines

}  // namespace

double automatic_kernel_size(double mean_edge, double diagonal) {
    return std::max(kLeastKernelEdges * mean_edge, kLeastShare * diagonal);
}

double global_kernel_size(const PreparedMesh& mesh, const PrecomputeOptions& options) {
    if (options.drawn_kernel_size > 0) {
        const double least = options.least_drawn_edges * mesh.mean_edge;
        return std::clamp(options.drawn_kernel_size / mesh.diagonal, least,
                          std::max(least, kLargestDrawnKernel));
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
    std::vector<double> lengths = mean_edges(mesh, ranges, part(0));
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
