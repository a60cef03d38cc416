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
constexpr double kMostCost = 1e7;   // as pairs_cost() has it: about ten seconds
constexpr double kSmoothed = 0.25;  // of the time

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

/// The linear function that fits S best around a vertex, at the vertex.
struct TensorFit {
    Eigen::Vector3d value;  ///< S(u,u), S(u,v), S(v,v)
    CubicForm slopes;       ///< over a radius
};

/// Returns false if the neighbours do not spread in all directions.
bool fit(const TensorSums& sums, std::size_t lane, TensorFit& fit) {
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
        fit.value[i] = mean - by_x[i] * x - by_y[i] * y;
    }
    fit.slopes =
        CubicForm::of(by_x[0], (by_y[0] + 2 * by_x[1]) / 3, (by_x[2] + 2 * by_y[1]) / 3, by_y[2]);
    return std::isfinite(fit.slopes.entries().sum() + fit.value.sum());
}

/// Fits around all vertices, one leaf of the tree after the other.
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

    /// Whether the sums over all that is within a reach would take seconds.
    bool is_endless(double reach) const { return pairs_cost(tree_, radius(0, reach)) > kMostCost; }

    /// Calls take(v, fit, radius) for each vertex, on any thread; without a fit where there is
    /// none. `reach` is in √h.
    template <class Take>
    void fit_all(double reach, const StageProgress& stage, const Take& take) const {
        parallel_for<Sources>(tree_.leaves().size(), stage, [&](std::size_t i, Sources& sources) {
            fit_leaf(tree_.leaves()[i], reach, sources, take);
        });
    }

private:
    /// Within which vertices count for v, local.
    double radius(std::uint32_t v, double reach) const {
        const double size = field_.kernel_sizes[mesh_.original_vertex[v]];
        return reach / kDerivativeReach *
               std::min(kDerivativeReach * size / mesh_.diagonal, most_per_size_ * size);
    }

    template <class Take>
    void fit_leaf(const SpatialTree::Leaf& leaf, double reach, Sources& sources,
                  const Take& take) const {
        const Eigen::Vector3d centre = leaf.box.center();
        double largest = 0;
        for (std::uint32_t v = leaf.begin; v < leaf.end; ++v)
            largest = std::max(largest, radius(v, reach));
        const std::size_t count = collect(leaf, centre, largest, sources);
        for (std::uint32_t begin = leaf.begin; begin < leaf.end; begin += kSlopeLanes) {
            TensorSums sums;
            sum_tensors(targets(leaf, begin, centre, reach), sources.data(), count, sums);
            for (std::uint32_t lane = 0; lane < kSlopeLanes && begin + lane < leaf.end; ++lane) {
                const std::uint32_t v = begin + lane;
                const double r = radius(v, reach);
                TensorFit found;
                take(v, r > 0 && fit(sums, lane, found) ? &found : nullptr, r);
            }
        }
    }

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
                          const Eigen::Vector3d& centre, double reach) const {
        TensorTargets t = {};
        for (std::uint32_t lane = 0; lane < kSlopeLanes; ++lane) {
            const std::uint32_t v = std::min(begin + lane, leaf.end - 1);
            const CurvedVertex& vertex = vertices_[v];
            const double r = radius(v, reach);
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

std::vector<CubicForm> differentiate(const PreparedMesh& mesh, const VertexRanges& ranges,
                                     const Vertices& vertices, const Fits& fits,
                                     const StageProgress& stage) {
    if (fits.is_endless(kDerivativeReach)) return ring_derivatives(mesh, ranges, vertices);
    std::vector<CubicForm> forms = large_array<CubicForm>(mesh.size());
    std::vector<std::uint8_t> failed(mesh.size());
    fits.fit_all(kDerivativeReach, stage,
                 [&](std::uint32_t v, const TensorFit* fit, double radius) {
                     failed[v] = fit == nullptr;
                     if (!fit) return;
                     forms[v] = fit->slopes;
                     forms[v].scale(1 / radius);
                 });
    if (std::find(failed.begin(), failed.end(), 1) == failed.end()) return forms;
    const std::vector<CubicForm> others = ring_derivatives(mesh, ranges, vertices);
    for_each_element(mesh.size(), [&](std::size_t v) {
        if (failed[v]) forms[v] = others[v];
    });
    return forms;
}

/// S(u,u), S(u,v), S(v,v), smoothed where there is a fit.
std::vector<Eigen::Vector3d> smooth(const PreparedMesh& mesh, const Vertices& vertices,
                                    const Fits& fits, const StageProgress& stage) {
    std::vector<Eigen::Vector3d> smoothed = large_array<Eigen::Vector3d>(mesh.size());
    for_each_element(mesh.size(), [&](std::size_t i) {
        const CurvedVertex& v = vertices[i];
        const SymmetricTensor& s = v.shape_operator;
        smoothed[i] = {v.u.dot(s * v.u), v.u.dot(s * v.v), v.v.dot(s * v.v)};
    });
    if (fits.is_endless(kSmoothReach)) return smoothed;
    fits.fit_all(kSmoothReach, stage, [&](std::uint32_t v, const TensorFit* fit, double) {
        if (fit) smoothed[v] = fit->value;
    });
    return smoothed;
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
    const Fits fits(mesh, tree, vertices, field);
    const auto smoothed = smooth(mesh, vertices, fits, stage.part(0, kSmoothed));
    const auto forms = differentiate(mesh, ranges, vertices, fits, stage.part(kSmoothed, 1));
    auto& curvatures = field.smooth_curvatures;
    auto& derivatives = field.curvature_derivatives;
    curvatures = large_array(field.normals.size(), Eigen::Vector3f(Eigen::Vector3f::Zero()));
    derivatives = large_array(field.normals.size(), Eigen::Vector4f(Eigen::Vector4f::Zero()));
    for_each_element(mesh.size(), [&](std::size_t i) {
        const std::uint32_t v = mesh.original_vertex[i];
        curvatures[v] = (smoothed[i] / d).unaryExpr(&to_float);
        derivatives[v] = (forms[i].entries() / d / d).unaryExpr(&to_float);
    });
    const std::vector<std::uint32_t>& representative = mesh.representative;
    for_each_element(representative.size(), [&](std::size_t v) {
        if (representative[v] == v) return;
        curvatures[v] = curvatures[representative[v]];
        derivatives[v] = derivatives[representative[v]];
    });
}

}  // namespace laplacian_lines
