// SPDX-License-Identifier: GPL-3.0-or-later
// Eq. 2 of Laplacian Lines at every vertex,
//     Δn(p) = 1/(4πh²) Σ_q m_q exp(−‖q − p‖²/4h) (n_q − n_p):
//  1. Find where a direct sum may be cut off: where what is left of it is the accuracy asked for.
//  2. Sum by the cheaper way: directly, or on a grid (sums/gaussian_sums.h).
//  3. Make up for the part that was cut off, and for what the kernel lacks beyond a border.
#include "field/field_steps.h"

#include <algorithm>
#include <cmath>

#include "sums/gaussian_sums.h"
#include "sums/summation_cost.h"
#include "system/large_array.h"

namespace laplacian_lines {
namespace {

constexpr double kPi = EIGEN_PI;
constexpr double kQuickAccuracy = 5e-4;  // from this relative error on, quick Gaussians will do
// Share of the kernel's mass that is on the surface; less is at tips and on narrow strips.
constexpr double kLeastKernelMass = 0.2;

/// The share of the kernel's second moment, ∫ r² exp(−r²/4h), that is beyond k √h; u = k²/4.
double tail(double u) {
    return (1 + u) * std::exp(-u);
}

/// RMS of √h‖S‖: by how much the normal turns within √h.
double normal_turn(double kernel_size, const ShapeOperators& shape_operators) {
    const std::size_t count = shape_operators.size();
    const auto squares = [&](std::size_t i) { return shape_operators[i].squaredNorm(); };
    return kernel_size * std::sqrt(sum_of(count, squares) / double(count));
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

/// Δn at a vertex with the normal n and shape operator S, where the kernel lacks its part beyond a
/// border. `sum` is Δn without correction, `moment` the sum that has q − p for n_q − n_p, and
/// `mass` the share of the kernel that is on the surface.
Eigen::Vector3d corrected(const Eigen::Vector3d& sum, const Eigen::Vector3d& n,
                          const SymmetricTensor& s, double h, const Eigen::Vector3d& moment,
                          double mass) {
    // To first order n_q − n_p = S (q − p): a kernel with a first moment along the surface adds S
    // times that, which is taken away; less of it where the normal turns by more than a radian
    // within √h and the first order is not enough.
    const double trust = 1 / (1 + h * s.squaredNorm());
    const Eigen::Vector3d centred = sum - trust * (s * (moment - n * n.dot(moment)));
    // What the missing share would have added is made up for along n alone: that also halves the
    // bias on curved surfaces, but would worsen tangential parts.
    return centred + n * n.dot(centred) * (1 / std::max(mass, kLeastKernelMass) - 1);
}

}  // namespace

std::vector<Eigen::Vector3d> belkin_laplacian(const PreparedMesh& mesh, const SpatialTree& tree,
                                              const std::vector<Eigen::Vector3d>& normals,
                                              double kernel_size,
                                              const ShapeOperators& shape_operators,
                                              const PrecomputeOptions& options,
                                              const StageProgress& stage) {
    GaussianKernel kernel;
    kernel.size = kernel_size;
    kernel.quick = options.accuracy >= kQuickAccuracy;
    kernel.cutoff = cutoff_of(options.accuracy - (kernel.quick ? kQuickError : 0));
    kernel.facing = options.skip_opposite_sheet;
    const GridResolution resolution =
        grid_resolution(options.accuracy, normal_turn(kernel_size, shape_operators));
    const SummationCosts costs = summation_costs(mesh, tree, kernel, resolution);
    refuse_costly_sum(std::min(costs.direct, costs.grid),
                      "Merge close vertices, or choose a larger Kernel Size.");
    const bool on_grid = costs.grid < costs.direct;
    const GaussianSums sums = on_grid ? grid_sums(mesh, normals, kernel, resolution, stage)
                                      : gaussian_sums(mesh, tree, normals, kernel, stage);
    const double kept = on_grid ? 1 : 1 - tail(kernel.cutoff * kernel.cutoff / 4);
    std::vector<Eigen::Vector3d> laplacian = large_array<Eigen::Vector3d>(mesh.size());
    const double h = kernel_size * kernel_size, factor = 1 / (4 * kPi * h * h * kept);
    for_each_element(laplacian.size(), [&](std::size_t i) {
        laplacian[i] = factor * sums.normal_difference[i].cast<double>();
        if (options.correct_borders)
            laplacian[i] = corrected(laplacian[i], normals[i], shape_operators[i], h,
                                     factor * sums.first_moment[i].cast<double>(),
                                     sums.mass[i] / (4 * kPi * h));
    });
    return laplacian;
}

}  // namespace laplacian_lines
