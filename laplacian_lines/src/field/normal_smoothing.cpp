// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/field_steps.h"

#include <cmath>

#include "sums/gaussian_sums.h"
#include "sums/summation_cost.h"

namespace laplacian_lines {
namespace {

constexpr double kCutoffInSigma = 3;
constexpr double kDegree = 3.14159265358979323846 / 180;
constexpr double kLeastSigma = 1e-7;  // in D; no vertex has a nearer neighbour
constexpr double kAccuracy = 1e-3;    // of a sum on the grid
// Least cost of the direct sum over that of the grid, which also sums the Gaussian's tails and so
// differs a little.
constexpr double kGridAdvantage = 4;

GaussianSums smoothing_sums(const PreparedMesh& mesh, const SpatialTree& tree,
                            const std::vector<Eigen::Vector3d>& normals,
                            const GaussianKernel& kernel, const StageProgress& stage) {
    const GridResolution resolution = grid_resolution(kAccuracy, 1);
    const SummationCosts costs = summation_costs(mesh, tree, kernel, resolution);
    if (kernel.normal_falloff == 0 && costs.grid * kGridAdvantage < costs.direct)
        return grid_sums(mesh, normals, kernel, resolution, stage);
    refuse_costly_sum(costs.direct,
                      "Merge close vertices, or choose another Normal Smoothing or a smaller "
                      "Normal Smoothing Sigma.");
    return gaussian_sums(mesh, tree, normals, kernel, stage);
}

}  // namespace

void smooth_normals(const PreparedMesh& mesh, const SpatialTree& tree,
                    const std::vector<float>& relative_sizes, double sigma,
                    const PrecomputeOptions& options, const StageProgress& stage,
                    std::vector<Eigen::Vector3d>& normals) {
    if (options.normal_smoothing == NormalSmoothing::None || !(sigma > kLeastSigma)) return;
    GaussianKernel kernel;
    kernel.kernel_sizes = relative_sizes;
    for (float& size : kernel.kernel_sizes)
        size *= float(sigma / std::sqrt(2.0));
    kernel.cutoff = kCutoffInSigma * std::sqrt(2.0);
    if (options.normal_smoothing == NormalSmoothing::Bilateral)
        kernel.normal_falloff =
            0.5 / std::pow(2 * std::sin(options.bilateral_angle * kDegree / 2), 2);
    const GaussianSums sums = smoothing_sums(mesh, tree, normals, kernel, stage);
    for_each_element(normals.size(), [&](std::size_t i) {
        normals[i] = (double(sums.mass[i]) * normals[i] + sums.normal_difference[i].cast<double>())
                         .stableNormalized();
    });
}

}  // namespace laplacian_lines
