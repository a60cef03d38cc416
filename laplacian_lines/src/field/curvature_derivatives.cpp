// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/curvature_derivatives.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "field/ring_derivatives.h"
#include "field/tensor_slopes.h"
#include "laplacian_lines/tangent_frame.h"
#include "sums/summation_cost.h"
#include "system/large_array.h"

namespace laplacian_lines {
namespace {

constexpr double kLargestFloat = 1e38;
constexpr double kLargestCurvature = 1e15;  // 1/D; sums of it with squares of lengths stay floats
/// Of the places of the neighbours along the direction in which they vary least, in squared radii:
/// 1/8 all around, 1/20 at a border.
constexpr double kLeastVariance = 0.004;
constexpr double kMostCost = 1e7;  // as pairs_cost() has it: about ten seconds

using Vertices = std::vector<CurvedVertex>;

float bounded(double x) {
    return float(std::clamp(x, -kLargestCurvature, kLargestCurvature));
}

CurvedVertex vertex_of(const Field& field, std::size_t v, double diagonal) {
    const Eigen::Vector3f& n = field.normals[v];
    const TangentFrame frame = tangent_frame(n);
    const ShapeOperator& s = field.shape_operators[v];
    SymmetricTensor local = {s.xx, s.yy, s.zz, s.yz, s.xz, s.xy};
    local.scale(diagonal);
    return {n.cast<double>(), frame.u.cast<double>(), frame.v.cast<double>(), local};
}

/// As the vertices of any leaf see it, but for its place.
TensorSource source_of(const CurvedVertex& vertex, double mass) {
    const Eigen::Vector3f n = vertex.normal.cast<float>();
    const SymmetricTensor& s = vertex.shape_operator;
    return {0,
            0,
            0,
            float(mass),
            {n.x(), n.y(), n.z()},
            bounded(s.xx),
            bounded(s.yy),
            bounded(s.zz),
            bounded(s.yz),
            bounded(s.xz),
            bounded(s.xy)};
}

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

/// Fits around the vertices of one leaf of the tree after the other.
class Fits {
public:
    Fits(const PreparedMesh& mesh, const SpatialTree& tree, const Vertices& vertices,
         const Field& field)
        : mesh_(mesh),
          tree_(tree),
          vertices_(vertices),
          field_(field),
          packed_(large_array<TensorSource>(mesh.size())) {
        const double per_size = field.scale.kernel_size > 0 ? 1 / field.scale.kernel_size : 0;
        most_per_size_ = kMostDerivativeReach * mesh.mean_edge * per_size;
        const double mass = sum_of(mesh.size(), [&](std::size_t v) { return mesh.masses[v]; });
        const double per_mass = mass > 0 ? double(mesh.size()) / mass : 0;
        for_each_element(mesh.size(), [&](std::size_t v) {
            packed_[v] = source_of(vertices[v], mesh.masses[v] * per_mass);
        });
    }

    /// Writes the forms of the leaf's vertices, and 1 where there is none.
    void fit_leaf(const SpatialTree::Leaf& leaf, Sources& sources, std::vector<CubicForm>& forms,
                  std::vector<std::uint8_t>& failed) const {
        const Eigen::Vector3d centre = leaf.box.center();
        double reach = 0;
        for (std::uint32_t v = leaf.begin; v < leaf.end; ++v)
            reach = std::max(reach, radius(v));
        const std::size_t count = collect(leaf, centre, reach, sources);
        for (std::uint32_t begin = leaf.begin; begin < leaf.end; begin += kSlopeLanes) {
            TensorSums sums;
            sum_tensors(targets(leaf, begin, centre), sources.data(), count, sums);
            for (std::size_t lane = 0; lane < kSlopeLanes && begin + lane < leaf.end; ++lane) {
                const std::size_t v = begin + lane;
                const double r = radius(std::uint32_t(v));
                failed[v] = !(r > 0 && fit(sums, lane, forms[v]));
                forms[v].scale(failed[v] ? 0 : 1 / r);
            }
        }
    }

    /// Within which vertices count for v, local.
    double radius(std::uint32_t v) const {
        const double size = field_.kernel_sizes[mesh_.original_vertex[v]];
        return std::min(kDerivativeReach * size / mesh_.diagonal, most_per_size_ * size);
    }

private:
    /// Returns how many there are.
    std::size_t collect(const SpatialTree::Leaf& leaf, const Eigen::Vector3d& centre, double reach,
                        Sources& sources) const {
        std::size_t count = 0;
        tree_.visit_leaves(leaf.box, reach, [&](const SpatialTree::Leaf& other) {
            if (sources.size() < count + SpatialTree::kLeafSize)
                sources.resize(2 * count + SpatialTree::kLeafSize);
            for (std::uint32_t q = other.begin; q < other.end; ++q) {
                const Eigen::Vector3d& p = mesh_.positions[q];
                if (leaf.box.squaredExteriorDistance(p) >= reach * reach) continue;
                TensorSource& source = sources[count++];
                source = packed_[q];
                source.x = float(p.x() - centre.x());
                source.y = float(p.y() - centre.y());
                source.z = float(p.z() - centre.z());
            }
        });
        return count;
    }

    TensorTargets targets(const SpatialTree::Leaf& leaf, std::uint32_t begin,
                          const Eigen::Vector3d& centre) const {
        TensorTargets t = {};
        for (std::uint32_t lane = 0; lane < kSlopeLanes; ++lane) {
            const std::uint32_t v = std::min(begin + lane, leaf.end - 1);
            const CurvedVertex& vertex = vertices_[v];
            const double r = radius(v);
            for (int k = 0; k < 3; ++k) {
                t.position[k][lane] = float(mesh_.positions[v][k] - centre[k]);
                t.normal[k][lane] = float(vertex.normal[k]);
                t.u[k][lane] = float(vertex.u[k]);
                t.v[k][lane] = float(vertex.v[k]);
            }
            t.per_radius[lane] = r > 0 ? float(1 / r) : 0.f;
        }
        return t;
    }

    const PreparedMesh& mesh_;
    const SpatialTree& tree_;
    const Vertices& vertices_;
    const Field& field_;
    Sources packed_;
    double most_per_size_;
};

std::vector<CubicForm> differentiate(const PreparedMesh& mesh, const SpatialTree& tree,
                                     const VertexRanges& ranges, const Vertices& vertices,
                                     const Field& field, const StageProgress& stage) {
    const Fits fits(mesh, tree, vertices, field);
    if (pairs_cost(tree, fits.radius(0)) > kMostCost)
        return ring_derivatives(mesh, ranges, vertices);
    std::vector<CubicForm> forms = large_array<CubicForm>(mesh.size());
    std::vector<std::uint8_t> failed(mesh.size());
    parallel_for<Sources>(tree.leaves().size(), stage, [&](std::size_t i, Sources& sources) {
        fits.fit_leaf(tree.leaves()[i], sources, forms, failed);
    });
    if (std::find(failed.begin(), failed.end(), 1) == failed.end()) return forms;
    const std::vector<CubicForm> others = ring_derivatives(mesh, ranges, vertices);
    for_each_element(mesh.size(), [&](std::size_t v) {
        if (failed[v]) forms[v] = others[v];
    });
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
    Vertices vertices = large_array<CurvedVertex>(mesh.size());
    for_each_element(mesh.size(), [&](std::size_t i) {
        vertices[i] = vertex_of(field, mesh.original_vertex[i], d);
    });
    const std::vector<CubicForm> forms = differentiate(mesh, tree, ranges, vertices, field, stage);
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
