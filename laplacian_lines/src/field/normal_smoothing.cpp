// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/field_steps.h"

#include <cmath>

#include "sums/gaussian_sums.h"
#include "sums/summation_cost.h"

namespace laplacian_lines {
namespace {

constexpr double kCutoffInSigma = 3;
constexpr double kLeastSigma = 1e-7;  // in D; less than the sides of real meshes
constexpr double kAccuracy = 1e-3;    // of a sum on the grid
// Least cost of the direct sum over that of the grid, which also sums the Gaussian's tails and so
// differs a little.
constexpr double kGridAdvantage = 4;

GaussianSums smoothing_sums(const PreparedMesh& mesh, const SpatialTree& tree,
                            const std::vector<Eigen::Vector3d>& normals,
                            const GaussianKernel& kernel, const StageProgress& stage) {
    const GridResolution resolution = grid_resolution(kAccuracy, 1);
    const SummationCosts costs = summation_costs(mesh, tree, kernel, resolution);
    if (costs.grid * kGridAdvantage < costs.direct)
        return grid_sums(mesh, normals, kernel, resolution, stage);
    refuse_costly_sum(costs.direct,
                      "Merge close vertices, or choose a smaller Normal Smoothing Sigma.");
    return gaussian_sums(mesh, tree, normals, kernel, stage);
}

}  // namespace

void smooth_normals(const PreparedMesh& mesh, const SpatialTree& tree, double sigma,
                    const StageProgress& stage, std::vector<Eigen::Vector3d>& normals) {
    if (!(sigma > kLeastSigma)) return;
    GaussianKernel kernel;
    kernel.size = sigma / std::sqrt(2.0);
    kernel.cutoff = kCutoffInSigma * std::sqrt(2.0);
    const GaussianSums sums = smoothing_sums(mesh, tree, normals, kernel, stage);
    for_each_element(normals.size(), [&](std::size_t i) {
        normals[i] = (double(sums.mass[i]) * normals[i] + sums.normal_difference[i].cast<double>())
                         .stableNormalized();
    });
}

}  // namespace laplacian_lines
