// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/field_steps.h"

#include <algorithm>
#include <cmath>

#include "sums/gaussian_sums.h"
#include "sums/summation_cost.h"
#include "system/large_array.h"

namespace laplacian_lines {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kQuickAccuracy = 0.5e-3;  // least accuracy for which quick Gaussians will do
// Share of the kernel's mass that is on the surface; less is only at the tip of a border's corner.
constexpr double kLeastKernelMass = 0.2;

/// Of the kernel's second moment, beyond k √h, u = k²/4.
double tail(double u) {
    return (1 + u) * std::exp(-u);
}

double roughness(const std::vector<float>& kernel_sizes, const ShapeOperators& shape_operators) {
    const double sum = sum_of(kernel_sizes.size(), [&](std::size_t i) {
        return double(kernel_sizes[i]) * kernel_sizes[i] * shape_operators[i].squaredNorm();
    });
    return std::sqrt(sum / double(kernel_sizes.size()));
}

/// Radius, in √h, beyond which the part `accuracy` of the kernel's second moment lies.
double cutoff_of(double accuracy) {
    double low = 0, high = 100;  // tail() falls from 1 to 4e-42
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (tail(middle) > accuracy ? low : high) = middle;
    }
    return 2 * std::sqrt(high);
}

}  // namespace

std::vector<Eigen::Vector3d> belkin_laplacian(const PreparedMesh& mesh, const SpatialTree& tree,
                                              const std::vector<Eigen::Vector3d>& normals,
                                              const std::vector<float>& kernel_sizes,
                                              const ShapeOperators& shape_operators,
                                              const PrecomputeOptions& options,
                                              const StageProgress& stage) {
    GaussianKernel kernel;
    kernel.kernel_sizes = kernel_sizes;
    kernel.quick = options.accuracy >= kQuickAccuracy;
    kernel.cutoff = cutoff_of(options.accuracy - (kernel.quick ? kQuickError : 0));
    kernel.facing = options.skip_opposite_sheet;
    const GridResolution resolution =
        grid_resolution(options.accuracy, roughness(kernel_sizes, shape_operators));
    const SummationCosts costs = summation_costs(mesh, tree, kernel, resolution);
    refuse_costly_sum(std::min(costs.direct, costs.grid),
                      "Merge close vertices, or choose a larger Kernel Size.");
    const bool on_grid = costs.grid < costs.direct;
    const GaussianSums sums = on_grid ? grid_sums(mesh, normals, kernel, resolution, stage)
                                      : gaussian_sums(mesh, tree, normals, kernel, stage);
    // The cut-off tail of a second moment is known, so its mean effect is corrected.
    const double kept = on_grid ? 1 : 1 - tail(kernel.cutoff * kernel.cutoff / 4);
    std::vector<Eigen::Vector3d> laplacian = large_array<Eigen::Vector3d>(mesh.size());
    for_each_element(laplacian.size(), [&](std::size_t i) {
        const double h = double(kernel_sizes[i]) * kernel_sizes[i];
        const double factor = 1 / (4 * kPi * h * h * kept);
        laplacian[i] = factor * sums.normal_difference[i].cast<double>();
        if (!options.correct_borders) return;
        const Eigen::Vector3d& n = normals[i];
        const Eigen::Vector3d moment = factor * sums.first_moment[i].cast<double>();
        // A kernel that is asymmetric around p, as at a border, has a first moment along the
        // surface, which S turns into a spurious term. It fades where the normal turns by more than
        // a radian within √h, since n_q − n_p = S (q − p) does not hold there.
        const double trust = 1 / (1 + h * shape_operators[i].squaredNorm());
        laplacian[i] -= trust * (shape_operators[i] * (moment - n * n.dot(moment)));
        // Part of the kernel is missing there, too. This also halves the bias on curved surfaces,
        // but worsens tangential parts.
        const double kernel_mass = std::max(sums.mass[i] / (4 * kPi * h), kLeastKernelMass);
        laplacian[i] += n * n.dot(laplacian[i]) * (1 / kernel_mass - 1);
    });
    return laplacian;
}

}  // namespace laplacian_lines
