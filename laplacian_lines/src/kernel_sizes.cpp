// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel_sizes.h"

#include <algorithm>

namespace laplacian_lines {
namespace {

constexpr int kSmoothingPasses = 10;
constexpr double kSmallestRatio = 0.25, kLargestRatio = 4;

/// Mean length of the edges at each vertex; inner edges count once per triangle.
std::vector<double> local_edge_lengths(const PreparedMesh& mesh) {
    std::vector<double> lengths(mesh.size(), 0), counts(mesh.size(), 0);
    for (const Triangle& t : mesh.triangles)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            const double length = (mesh.positions[b] - mesh.positions[a]).norm();
            for (std::uint32_t v : {a, b}) {
                lengths[v] += length;
                counts[v] += 1;
            }
        }
    for (std::size_t v = 0; v < lengths.size(); ++v)
        lengths[v] /= counts[v];
    return lengths;
}

void average_over_one_rings(const PreparedMesh& mesh, std::vector<double>& values) {
    std::vector<double> sums = values, counts(values.size(), 1);
    for (const Triangle& t : mesh.triangles)
        for (int k = 0; k < 3; ++k) {
            sums[t[k]] += values[t[(k + 1) % 3]] + values[t[(k + 2) % 3]];
            counts[t[k]] += 2;
        }
    for (std::size_t v = 0; v < values.size(); ++v)
        values[v] = sums[v] / counts[v];
}

}  // namespace

double automatic_kernel_size(double mean_edge, double diagonal) {
    return std::max(2 * mean_edge, 0.0045 * diagonal);
}

double global_kernel_size(const PreparedMesh& mesh, const PrecomputeOptions& options) {
    return options.kernel_size > 0 ? options.kernel_size / mesh.diagonal
                                   : automatic_kernel_size(mesh.mean_edge, 1);
}

std::vector<float> relative_kernel_sizes(const PreparedMesh& mesh, KernelMode mode) {
    if (mode == KernelMode::Uniform) return std::vector<float>(mesh.size(), 1.f);
    std::vector<double> lengths = local_edge_lengths(mesh);
    for (int pass = 0; pass < kSmoothingPasses; ++pass)
        average_over_one_rings(mesh, lengths);
    std::vector<float> ratios(mesh.size());
    for (std::size_t v = 0; v < ratios.size(); ++v)
        ratios[v] = float(std::clamp(lengths[v] / mesh.mean_edge, kSmallestRatio, kLargestRatio));
    return ratios;
}

}  // namespace laplacian_lines
