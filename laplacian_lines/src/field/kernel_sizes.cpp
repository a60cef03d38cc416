// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "field/field_steps.h"

namespace laplacian_lines {
namespace {

// In D. Beyond these, nothing changes: no vertex is within the kernel, or all are.
constexpr double kSmallestKernel = 1e-7, kLargestKernel = 1e4;
constexpr double kLargestDrawnKernel = 0.04;  // D
// Of the mean edge before refinement: less draws ripples where triangles meet.
constexpr double kRefinedShare = 0.6;
constexpr double kLeastShare = 0.0045;  // D: finer meshes do not get ever finer lines

}  // namespace

double automatic_kernel_size(double mean_edge, double diagonal) {
    return std::max(kLeastKernelEdges * mean_edge, kLeastShare * diagonal);
}

double kernel_size_of(const PreparedMesh& mesh, const PrecomputeOptions& options) {
    // of a Design, one for which kLeastKernelEdges make kDesignedKernel
    const double edge = mesh.origin == Origin::Design
                            ? kDesignedKernel / kLeastKernelEdges
                            : std::max(mesh.mean_edge, kRefinedShare * mesh.known_edge);
    if (options.drawn_kernel_size > 0) {
        const double least = options.least_drawn_edges * edge;
        return std::clamp(options.drawn_kernel_size / mesh.diagonal, least,
                          std::max(least, kLargestDrawnKernel));
    }
    return options.kernel_size > 0
               ? std::clamp(options.kernel_size / mesh.diagonal, kSmallestKernel, kLargestKernel)
               : automatic_kernel_size(edge, 1);
}

}  // namespace laplacian_lines
