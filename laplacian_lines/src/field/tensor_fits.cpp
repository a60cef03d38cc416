// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/tensor_fits.h"

#include <algorithm>
#include <cmath>

#include "laplacian_lines/tangent_frame.h"
#include "sums/summation_cost.h"
#include "system/large_array.h"
#include "system/simd_sets.h"

namespace laplacian_lines {
namespace {

/// Variance of the neighbours' places in the direction in which they vary least, in squared radii:
/// 1/8 all around, 1/20 at a border.
constexpr double kLeastVariance = 0.004;
constexpr double kMostCost = 1e7;  // as pairs_cost() has it: about ten seconds

/// Slopes are per radius.
TensorFit fit_of(const TensorSums& sums, std::size_t lane) {
    double n[TensorSums::kNumbers];
    for (int i = 0; i < TensorSums::kNumbers; ++i)
        n[i] = sums.numbers[i][lane];
    TensorFit fit;
    const double w = n[TensorSums::kWeight];
    if (!(w > 0)) return fit;
    const double x = n[TensorSums::kX] / w, y = n[TensorSums::kY] / w;
    const double xx = n[TensorSums::kXX] / w - x * x, xy = n[TensorSums::kXY] / w - x * y,
                 yy = n[TensorSums::kYY] / w - y * y;
    const double determinant = xx * yy - xy * xy, trace = xx + yy;
    // The smaller eigenvalue is at least the determinant over the trace.
    if (!(trace > 0 && determinant > kLeastVariance * trace)) return fit;
    double by_x[3], by_y[3];
    for (int i = 0; i < 3; ++i) {
        const double mean = n[TensorSums::kEntries + i] / w;
        const double sx = n[TensorSums::kXEntries + i] / w - x * mean;
        const double sy = n[TensorSums::kYEntries + i] / w - y * mean;
        by_x[i] = (yy * sx - xy * sy) / determinant;
        by_y[i] = (xx * sy - xy * sx) / determinant;
        fit.value[i] = mean - by_x[i] * x - by_y[i] * y;
    }
    fit.slopes =
        CubicForm::of(by_x[0], (by_y[0] + 2 * by_x[1]) / 3, (by_x[2] + 2 * by_y[1]) / 3, by_y[2]);
    fit.found = std::isfinite(fit.slopes.entries().sum() + fit.value.sum());
    return fit;
}

}  // namespace

TensorFits::TensorFits(const PreparedMesh& mesh, const SpatialTree& tree, const Field& field)
    : mesh_(mesh), tree_(tree), field_(field), sources_(mesh, tree, field) {}

std::vector<float> TensorFits::radii_of(double reach) const {
    const double per_size = field_.scale.kernel_size > 0 ? 1 / field_.scale.kernel_size : 0;
    const double longest =
        std::min(kDerivativeReach * derivative_kernel(field_.scale) / mesh_.diagonal,
                 kMostDerivativeReach * mesh_.mean_edge);
    const double factor = reach / kDerivativeReach * longest * per_size;
    std::vector<float> radii = large_array<float>(mesh_.size());
    for_each_element(mesh_.size(), [&](std::size_t v) {
        radii[v] = float(factor * field_.kernel_sizes[mesh_.original_vertex[v]]);
    });
    return radii;
}

bool TensorFits::is_endless(const std::vector<float>& radii) const {
    return !(pairs_cost(tree_, double(radii[0])) <= kMostCost);
}

void TensorFits::fit_leaf(const SpatialTree::Leaf& leaf, const std::vector<float>& radii,
                          Scratch& scratch) const {
    const float reach = *std::max_element(radii.begin() + leaf.begin, radii.begin() + leaf.end);
    const std::size_t count = sources_.collect(leaf, reach, scratch.sources);
    for (std::uint32_t begin = leaf.begin; begin < leaf.end; begin += kSlopeLanes) {
        TensorSums sums;
        fastest<SlopeLoops>().sum(targets(leaf, radii, begin), scratch.sources.data(), count, sums);
        for (std::uint32_t lane = 0; lane < kSlopeLanes && begin + lane < leaf.end; ++lane) {
            const double radius = radii[begin + lane];
            TensorFit& fit = scratch.fits[begin + lane - leaf.begin];
            fit = radius > 0 ? fit_of(sums, lane) : TensorFit();
            if (fit.found) fit.slopes.scale(1 / radius);
        }
    }
}

TensorTargets TensorFits::targets(const SpatialTree::Leaf& leaf, const std::vector<float>& radii,
                                  std::uint32_t begin) const {
    const Eigen::Vector3d centre = leaf.box.center();
    TensorTargets t = {};
    for (std::uint32_t lane = 0; lane < kSlopeLanes; ++lane) {
        const std::uint32_t v = std::min(begin + lane, leaf.end - 1);
        const Eigen::Vector3f& n = field_.normals[mesh_.original_vertex[v]];
        const TangentFrame frame = tangent_frame(n);
        const Eigen::Vector3f p = (mesh_.positions[v] - centre).cast<float>();
        for (int k = 0; k < 3; ++k) {
            t.position[k][lane] = p[k];
            t.normal[k][lane] = n[k];
            t.u[k][lane] = frame.u[k];
            t.v[k][lane] = frame.v[k];
        }
        t.per_radius[lane] = radii[v] > 0 ? 1 / radii[v] : 0.f;
    }
    return t;
}

}  // namespace laplacian_lines
