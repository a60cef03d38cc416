// SPDX-License-Identifier: GPL-3.0-or-later
// Around a vertex p with radius R, S of the neighbours q is fitted by S(x, y) = S₀ + x S_x + y S_y,
// x and y being q's place in p's tangent plane. With means over q, weighted as in tensor_sums.h:
//  1. The variances and the covariance of x and y: [xx xy; xy yy].
//  2. The covariances sx, sy of S with x and y.
//  3. S_x and S_y solve [xx xy; xy yy] [S_x; S_y] = [sx; sy], by Cramer's rule.
//  4. S₀ is the mean of S less what S_x and S_y add at the mean place.
// Vertices of a leaf of the tree share their neighbours, and many are summed at once.
#include "field/tensor_fits.h"

#include <algorithm>
#include <cmath>

#include "field/derivative_scale.h"
#include "laplacian_lines/tangent_frame.h"
#include "sums/summation_cost.h"
#include "system/simd_sets.h"

namespace laplacian_lines {
namespace {

// Largest radius for C, in mean edges: more is slower, not better. S̄'s is less in proportion.
constexpr double kMostDerivativeReach = 16;
constexpr double kLargestEntry = 1e15;  // of S, 1/D; sums with squares of lengths stay floats
// Least variance of the neighbours' positions in any direction, in squared radii; it is about 1/8
// inside and 1/25 at a border.
constexpr double kLeastVariance = 0.004;
constexpr double kMostCost = 1e7;  // as pairs_cost() has it: about ten seconds

/// The fit of least squares from its sums; slopes are per radius.
TensorFit fit_of(const TensorSums& sums, std::size_t lane) {
    using Sums = TensorSums;
    TensorFit fit;
    const double w = double(sums.numbers[Sums::kWeight][lane]);
    if (!(w > 0)) return fit;
    const auto mean = [&](int i) { return double(sums.numbers[i][lane]) / w; };
    const double x = mean(Sums::kX), y = mean(Sums::kY);
    const double xx = mean(Sums::kXX) - x * x, xy = mean(Sums::kXY) - x * y,
                 yy = mean(Sums::kYY) - y * y;
    const double determinant = xx * yy - xy * xy, trace = xx + yy;
    // The smaller eigenvalue is at least the determinant over the trace.
    if (!(trace > 0 && determinant > kLeastVariance * trace)) return fit;
    double by_x[3], by_y[3];  // of S(u,u), S(u,v), S(v,v)
    for (int i = 0; i < 3; ++i) {
        const double s = mean(Sums::kEntries + i);
        const double sx = mean(Sums::kXEntries + i) - x * s, sy = mean(Sums::kYEntries + i) - y * s;
        by_x[i] = (yy * sx - xy * sy) / determinant;
        by_y[i] = (xx * sy - xy * sx) / determinant;
        fit.value[i] = s - by_x[i] * x - by_y[i] * y;
    }
    fit.slopes = CubicForm::of(by_x, by_y);
    fit.found = std::isfinite(fit.slopes.entries().sum() + fit.value.sum());
    return fit;
}

/// The vertices with S·D; masses are in units of the mean one.
LeafSources<TensorSource> sources_of(const PreparedMesh& mesh, const SpatialTree& tree,
                                     const Field& field) {
    const double mass = sum_of(mesh.size(), [&](std::size_t v) { return mesh.masses[v]; });
    const double per_mass = mass > 0 ? double(mesh.size()) / mass : 0;
    const auto entry = [&](float x) {
        return float(std::clamp(mesh.diagonal * x, -kLargestEntry, kLargestEntry));
    };
    return {mesh, tree, [&](std::uint32_t v) {
                const Eigen::Vector3f& n = field.normals[mesh.original_vertex[v]];
                const ShapeOperator& s = field.shape_operators[mesh.original_vertex[v]];
                TensorSource source = {};
                source.mass = float(mesh.masses[v] * per_mass);
                std::copy(n.begin(), n.end(), source.normal);
                source.xx = entry(s.xx), source.yy = entry(s.yy), source.zz = entry(s.zz);
                source.yz = entry(s.yz), source.xz = entry(s.xz), source.xy = entry(s.xy);
                return source;
            }};
}

}  // namespace

TensorFits::TensorFits(const PreparedMesh& mesh, const SpatialTree& tree, const Field& field)
    : mesh_(mesh), tree_(tree), field_(field), sources_(sources_of(mesh, tree, field)) {}

void TensorFits::for_each(
    double reach, const StageProgress& stage,
    const std::function<void(std::uint32_t v, const TensorFit& fit)>& take) const {
    const double longest =
        std::min(kDerivativeReach * derivative_kernel(field_.scale) / mesh_.diagonal,
                 kMostDerivativeReach * mesh_.mean_edge);
    const double radius = reach / kDerivativeReach * longest;
    if (!(radius > 0 && pairs_cost(tree_, radius) <= kMostCost)) return;
    using Sources = std::vector<TensorSource>;
    parallel_for<Sources>(tree_.leaves().size(), stage, [&](std::size_t i, Sources& sources) {
        const SpatialTree::Leaf& leaf = tree_.leaves()[i];
        const std::size_t count = sources_.collect(leaf, radius, sources);
        for (std::uint32_t begin = leaf.begin; begin < leaf.end; begin += kTensorLanes) {
            TensorSums sums;
            fastest<TensorLoops>().sum(targets(leaf, radius, begin), sources.data(), count, sums);
            for (std::uint32_t v = begin; v < std::min(begin + kTensorLanes, leaf.end); ++v) {
                TensorFit fit = fit_of(sums, v - begin);
                if (!fit.found) continue;
                fit.slopes.scale(1 / radius);
                take(v, fit);
            }
        }
    });
}

/// The vertices from `begin` on, in their tangent planes.
TensorTargets TensorFits::targets(const SpatialTree::Leaf& leaf, double radius,
                                  std::uint32_t begin) const {
    const Eigen::Vector3d centre = leaf.box.center();
    TensorTargets t = {};
    for (std::uint32_t lane = 0; lane < kTensorLanes; ++lane) {
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
    }
    t.per_radius = float(1 / radius);
    return t;
}

}  // namespace laplacian_lines
