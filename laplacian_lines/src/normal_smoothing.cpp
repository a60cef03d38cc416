// SPDX-License-Identifier: GPL-3.0-or-later
#include "normal_smoothing.h"

#include <cmath>

namespace laplacian_lines {
namespace {

constexpr double kCutoffInSigma = 3;
constexpr double kDegree = 3.14159265358979323846 / 180;

}  // namespace

void smooth_normals(const PreparedMesh& mesh, const SpatialTree& tree,
                    const std::vector<float>& relative_sizes, double sigma,
                    const PrecomputeOptions& options, const StageProgress& stage,
                    std::vector<Eigen::Vector3d>& normals) {
    if (options.normal_smoothing == NormalSmoothing::None || !(sigma > 0)) return;
    GaussianKernel kernel;
    kernel.kernel_sizes = relative_sizes;
    for (float& size : kernel.kernel_sizes)
        size *= float(sigma / std::sqrt(2.0));
    kernel.cutoff = kCutoffInSigma * std::sqrt(2.0);
    if (options.normal_smoothing == NormalSmoothing::Bilateral)
        kernel.normal_falloff =
            0.5 / std::pow(2 * std::sin(options.bilateral_angle * kDegree / 2), 2);
    const GaussianSums sums = gaussian_sums(mesh, tree, normals, kernel, stage);
    for (std::size_t i = 0; i < normals.size(); ++i)
        normals[i] = (double(sums.mass[i]) * normals[i] + sums.normal_difference[i].cast<double>())
                         .stableNormalized();
}

}  // namespace laplacian_lines
