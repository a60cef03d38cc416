// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/curvature_derivatives.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "field/ring_derivatives.h"
#include "field/tensor_slopes.h"
#include "field/tensor_sources.h"
#include "laplacian_lines/tangent_frame.h"
#include "sums/summation_cost.h"
#include "system/large_array.h"

namespace laplacian_lines {
namespace {

constexpr double kLargestFloat = 1e38;
/// Of the places of the neighbours along the direction in which they vary least, in squared radii:
/// 1/8 all around, 1/20 at a border.
constexpr double kLeastVariance = 0.004;
constexpr double kMostCost = 1e7;  // as pairs_cost() has it: about ten seconds

using Sources = std::vector<TensorSource>;

/// The slopes of the linear fit; false if the neighbours do not spread in all directions.
bool fit(const TensorSums& sums, std::size_t lane, CubicForm& form) {
    double n[TensorSums::kNumbers];
    for (int i = 0; i < TensorSums::kNumbers; ++i)
        n[i] = sums.numbers[i][lane];
    const double w = n[TensorSums::kWeight];
    if (!(w > 0)) return false;
    const double x = n[TensorSums::kX] / w, y = n[TensorSums::kY] / w;
    const double xx = n[TensorSums::kXX] / w - x * x, xy = n[TensorSums::kXY] / w - x * y,
                 yy = n[TensorSums::kYY] / w - y * y;
    const double determinant = xx * yy - xy * xy, trace = xx + yy;
    // The smaller eigenvalue is at least the determinant over the trace.
    if (!(trace > 0 && determinant > kLeastVariance * trace)) return false;
    double by_x[3], by_y[3];
    for (int i = 0; i < 3; ++i) {
        const double mean = n[TensorSums::kEntries + i] / w;
        const double sx = n[TensorSums::kXEntries + i] / w - x * mean;
        const double sy = n[TensorSums::kYEntries + i] / w - y * mean;
        by_x[i] = (yy * sx - xy * sy) / determinant;
        by_y[i] = (xx * sy - xy * sx) / determinant;
    }
    form =
        CubicForm::of(by_x[0], (by_y[0] + 2 * by_x[1]) / 3, (by_x[2] + 2 * by_y[1]) / 3, by_y[2]);
    return std::isfinite(form.entries().sum());
}

/// Within which vertices count for each, local, [N].
std::vector<float> fit_radii(const PreparedMesh& mesh, const Field& field) {
    const double per_size = field.scale.kernel_size > 0 ? 1 / field.scale.kernel_size : 0;
    const double most_per_size = kMostDerivativeReach * mesh.mean_edge * per_size;
    const double reach = std::min(kDerivativeReach / mesh.diagonal, most_per_size);
    std::vector<float> radii = large_array<float>(mesh.size());
    for_each_element(mesh.size(), [&](std::size_t v) {
        radii[v] = float(reach * field.kernel_sizes[mesh.original_vertex[v]]);
    });
    return radii;
}

/// Fits around the vertices of one leaf of the tree after the other.
class Fits {
public:
    Fits(const PreparedMesh& mesh, const SpatialTree& tree, const Field& field,
         const std::vector<float>& radii)
        : mesh_(mesh), field_(field), radii_(radii), sources_(mesh, tree, field) {}

    /// Writes the forms of the leaf's vertices, and 1 where there is none.
    void fit_leaf(const SpatialTree::Leaf& leaf, Sources& scratch, std::vector<CubicForm>& forms,
                  std::vector<std::uint8_t>& failed) const {
        const double reach =
            *std::max_element(radii_.begin() + leaf.begin, radii_.begin() + leaf.end);
        const std::size_t count = sources_.collect(leaf, reach, scratch);
        for (std::uint32_t begin = leaf.begin; begin < leaf.end; begin += kSlopeLanes) {
            TensorSums sums;
            sum_tensors(targets(leaf, begin), scratch.data(), count, sums);
            for (std::size_t lane = 0; lane < kSlopeLanes && begin + lane < leaf.end; ++lane) {
                const std::size_t v = begin + lane;
                const double r = radii_[v];
                failed[v] = !(r > 0 && fit(sums, lane, forms[v]));
                forms[v].scale(failed[v] ? 0 : 1 / r);
            }
        }
    }

private:
    TensorTargets targets(const SpatialTree::Leaf& leaf, std::uint32_t begin) const {
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
            t.per_radius[lane] = radii_[v] > 0 ? 1 / radii_[v] : 0.f;
        }
        return t;
    }

    const PreparedMesh& mesh_;
    const Field& field_;
    const std::vector<float>& radii_;
    const TensorSources sources_;
};

std::vector<CubicForm> differentiate(const PreparedMesh& mesh, const SpatialTree& tree,
                                     const VertexRanges& ranges, const Field& field,
                                     const StageProgress& stage) {
    const std::vector<float> radii = fit_radii(mesh, field);
    std::vector<std::uint8_t> failed(mesh.size(), 1);
    std::vector<CubicForm> forms = large_array<CubicForm>(mesh.size());
    if (pairs_cost(tree, double(radii[0])) <= kMostCost) {
        const Fits fits(mesh, tree, field, radii);
        parallel_for<Sources>(tree.leaves().size(), stage, [&](std::size_t i, Sources& scratch) {
            fits.fit_leaf(tree.leaves()[i], scratch, forms, failed);
        });
    }
    set_ring_derivatives(mesh, ranges, field, failed, forms);
    return forms;
}

float to_float(double x) {
    return std::isfinite(x) ? float(std::clamp(x, -kLargestFloat, kLargestFloat)) : 0.f;
}

}  // namespace

void fill_curvature_derivatives(const PreparedMesh& mesh, const SpatialTree& tree,
                                const VertexRanges& ranges, const StageProgress& stage,
                                Field& field) {
    const double d = mesh.diagonal;
    const std::vector<CubicForm> forms = differentiate(mesh, tree, ranges, field, stage);
    auto& derivatives = field.curvature_derivatives;
    derivatives = large_array(field.normals.size(), Eigen::Vector4f(Eigen::Vector4f::Zero()));
    for_each_element(mesh.size(), [&](std::size_t i) {
        derivatives[mesh.original_vertex[i]] = (forms[i].entries() / d / d).unaryExpr(&to_float);
    });
    const std::vector<std::uint32_t>& representative = mesh.representative;
    for_each_element(representative.size(), [&](std::size_t v) {
        if (representative[v] != v) derivatives[v] = derivatives[representative[v]];
    });
}

}  // namespace laplacian_lines
