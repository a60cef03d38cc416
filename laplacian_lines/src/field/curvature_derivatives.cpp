// SPDX-License-Identifier: GPL-3.0-or-later
// C, the derivative of the shape operator S along the surface, and S̄, S smoothed, for the kinds of
// lines that need them:
//  1. Around each vertex, a linear function of the tangent plane is fitted to S of its neighbours:
//     S̄ is its value within a small radius, C its slope within a larger one.
//  2. Where too few neighbours are in reach, C is the mean of the differences within the triangles
//     at the vertex.
//  3. Both go back to the mesh's unit, and to vertices that were left out or welded.
#include <algorithm>
#include <cmath>

#include "field/cubic_form.h"
#include "field/derivative_scale.h"
#include "field/field_steps.h"
#include "field/tensor_slopes.h"
#include "laplacian_lines/tangent_frame.h"
#include "sums/leaf_sources.h"
#include "sums/summation_cost.h"
#include "system/simd_sets.h"

namespace laplacian_lines {
namespace {

constexpr double kLargestFloat = 1e38;
constexpr double kSmoothed = 0.3;  // of the time

// Radius R for C, in derivative_kernel(): (1 − d²/R²)² spreads like a kernel of 0.85 √h.
constexpr double kDerivativeReach = 3.4;
// Largest radius for C, in mean edges: more is slower, not better. S̄'s is reduced by the same
// factor.
constexpr double kMostDerivativeReach = 16;
// Radius for S̄, like a kernel of 0.35 √h: keeps visible form, removes noise of a fifth of the
// edges.
constexpr double kSmoothReach = 1.4;
constexpr double kLargestCurvature = 1e15;  // 1/D; sums of it with squares of lengths stay floats
// Smallest variance of the neighbours' positions over all directions, in squared radii: 1/8 inside,
// 1/20 at a border.
constexpr double kLeastVariance = 0.004;
// Between a triangle's normal and its corners'; below, S is of another side.
constexpr double kLeastCosine = 0.1;
constexpr double kMostCost = 1e7;  // as pairs_cost() has it: about ten seconds

/// The linear function in a vertex's tangent plane that fits S best, local units.
struct TensorFit {
    bool found = false;     ///< false: too few neighbours, or about on one line
    Eigen::Vector3d value;  ///< at the vertex: S(u,u), S(u,v), S(v,v)
    CubicForm slopes;       ///< made symmetric
};

/// The fit of least squares from its sums; slopes are per radius.
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

LeafSources<TensorSource> sources_of(const PreparedMesh& mesh, const SpatialTree& tree,
                                     const Field& field) {
    const double mass = sum_of(mesh.size(), [&](std::size_t v) { return mesh.masses[v]; });
    const double per_mass = mass > 0 ? double(mesh.size()) / mass : 0;
    const auto bounded = [&](float x) {
        return float(std::clamp(mesh.diagonal * x, -kLargestCurvature, kLargestCurvature));
    };
    return {mesh, tree, [&](std::uint32_t v) -> TensorSource {
                const Eigen::Vector3f& n = field.normals[mesh.original_vertex[v]];
                const ShapeOperator& s = field.shape_operators[mesh.original_vertex[v]];
                return {0,
                        0,
                        0,
                        float(mesh.masses[v] * per_mass),
                        {n.x(), n.y(), n.z()},
                        bounded(s.xx),
                        bounded(s.yy),
                        bounded(s.zz),
                        bounded(s.yz),
                        bounded(s.xz),
                        bounded(s.xy)};
            }};
}

/// Fits S of the vertices around each vertex, weighted by mass, nearness and how they face.
class TensorFits {
public:
    TensorFits(const PreparedMesh& mesh, const SpatialTree& tree, const Field& field)
        : mesh_(mesh), tree_(tree), field_(field), sources_(sources_of(mesh, tree, field)) {}

    /// Calls take(v, fit), on any thread, for each vertex that has a fit within `reach` kernels;
    /// for none if the sums would take too long.
    template <class Take>
    void for_each(double reach, const StageProgress& stage, const Take& take) const {
        const std::vector<float> radii = radii_of(reach);
        if (!(pairs_cost(tree_, double(radii[0])) <= kMostCost)) return;
        using Sources = std::vector<TensorSource>;
        parallel_for<Sources>(tree_.leaves().size(), stage, [&](std::size_t i, Sources& sources) {
            const SpatialTree::Leaf& leaf = tree_.leaves()[i];
            const float most =
                *std::max_element(radii.begin() + leaf.begin, radii.begin() + leaf.end);
            const std::size_t count = sources_.collect(leaf, double(most), sources);
            for (std::uint32_t begin = leaf.begin; begin < leaf.end; begin += kSlopeLanes) {
                TensorSums sums;
                fastest<SlopeLoops>().sum(targets(leaf, radii, begin), sources.data(), count, sums);
                const std::uint32_t end = std::min(begin + kSlopeLanes, leaf.end);
                for (std::uint32_t v = begin; v < end; ++v) {
                    if (!(radii[v] > 0)) continue;
                    TensorFit fit = fit_of(sums, v - begin);
                    fit.slopes.scale(1 / double(radii[v]));
                    if (fit.found) take(v, fit);
                }
            }
        });
    }

private:
    std::vector<float> radii_of(double reach) const {
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

    TensorTargets targets(const SpatialTree::Leaf& leaf, const std::vector<float>& radii,
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

    const PreparedMesh& mesh_;
    const SpatialTree& tree_;
    const Field& field_;
    const LeafSources<TensorSource> sources_;
};

/// A vertex whose S is differentiated, local units.
struct CurvedVertex {
    Eigen::Vector3d normal, u, v;  // orthonormal
    SymmetricTensor shape_operator;
};

CurvedVertex curved_vertex(const PreparedMesh& mesh, const Field& field, std::uint32_t v) {
    const std::uint32_t original = mesh.original_vertex[v];
    const Eigen::Vector3f& n = field.normals[original];
    const TangentFrame frame = tangent_frame(n);
    const ShapeOperator& s = field.shape_operators[original];
    SymmetricTensor local = {s.xx, s.yy, s.zz, s.yz, s.xz, s.xy};
    local.scale(mesh.diagonal);
    return {n.cast<double>(), frame.u.cast<double>(), frame.v.cast<double>(), local};
}

/// S(u,u), S(u,v), S(v,v) of a vertex.
Eigen::Vector3d entries_of(const CurvedVertex& v) {
    const Eigen::Vector3d su = v.shape_operator * v.u, sv = v.shape_operator * v.v;
    return {v.u.dot(su), v.u.dot(sv), v.v.dot(sv)};
}

/// Adds the derivative of S within a triangle, times its area, in the frames of its corners'
/// curved_vertex(): S is linear between corners, in the triangle's plane, and the result is made
/// symmetric, as on smooth surfaces (Codazzi). S. Rusinkiewicz, "Estimating Curvatures and Their
/// Derivatives on Triangle Meshes", 3DPVT 2004, section 4, without least squares. Adds nothing if
/// the triangle faces another way than its corners.
void add_differences(const PreparedMesh& mesh, const Field& field, const Triangle& t,
                     std::vector<CubicForm>& forms, std::vector<double>& areas) {
    const auto& p = mesh.positions;
    const Eigen::Vector3d edges[3] = {p[t[2]] - p[t[1]], p[t[0]] - p[t[2]], p[t[1]] - p[t[0]]};
    const Eigen::Vector3d area = area_vector(mesh, t), n = area / area.norm();
    const Eigen::Vector3d along = edges[0].stableNormalized(), beside = n.cross(along);
    // Of S(u, u), S(u, v), S(v, v), times the area.
    double by_along[3] = {}, by_beside[3] = {};
    std::complex<double> directions[3];  // of u in the corners' frames
    for (int k = 0; k < 3; ++k) {
        const CurvedVertex corner = curved_vertex(mesh, field, t[k]);
        const double cosine = n.dot(corner.normal);
        if (!(cosine > kLeastCosine)) return;
        // Rotate from the triangle's normal to the corner's by the smallest angle.
        const Eigen::Vector3d middle = (n + corner.normal) / (1 + cosine);
        const Eigen::Vector3d u = along - along.dot(corner.normal) * middle,
                              v = beside - beside.dot(corner.normal) * middle;
        const Eigen::Vector3d su = corner.shape_operator * u, sv = corner.shape_operator * v;
        const double entries[3] = {u.dot(su), v.dot(su), v.dot(sv)};
        for (int i = 0; i < 3; ++i) {
            by_along[i] -= edges[k].dot(beside) * entries[i];
            by_beside[i] += edges[k].dot(along) * entries[i];
        }
        directions[k] = {u.dot(corner.u), u.dot(corner.v)};
    }
    const CubicForm form = CubicForm::of(by_along[0], (by_beside[0] + 2 * by_along[1]) / 3,
                                         (by_along[2] + 2 * by_beside[1]) / 3, by_beside[2]);
    for (int k = 0; k < 3; ++k) {
        forms[t[k]].add(form.turned(directions[k]), 1);
        areas[t[k]] += area.norm();
    }
}

/// C of the vertices without a fit, from the triangles at each; 0 where none of these counts.
void fill_in(const PreparedMesh& mesh, const Field& field, const std::vector<std::uint8_t>& missing,
             std::vector<CubicForm>& derivatives) {
    if (std::find(missing.begin(), missing.end(), 1) == missing.end()) return;
    std::vector<CubicForm> sums(mesh.size());
    std::vector<double> areas(mesh.size());
    for (const Triangle& t : mesh.triangles)
        if (missing[t[0]] || missing[t[1]] || missing[t[2]])
            add_differences(mesh, field, t, sums, areas);
    for (std::size_t v = 0; v < mesh.size(); ++v) {
        if (!missing[v]) continue;
        derivatives[v] = sums[v];
        if (areas[v] > 0) derivatives[v].scale(1 / areas[v]);
    }
}

float to_float(double x) {
    return std::isfinite(x) ? float(std::clamp(x, -kLargestFloat, kLargestFloat)) : 0.f;
}

}  // namespace

void fill_curvature_derivatives(const PreparedMesh& mesh, const SpatialTree& tree,
                                const StageProgress& stage, Field& field) {
    const double d = mesh.diagonal;
    const TensorFits fits(mesh, tree, field);
    std::vector<Eigen::Vector3d> smoothed = large_array<Eigen::Vector3d>(mesh.size());
    for_each_element(mesh.size(), [&](std::size_t v) {
        smoothed[v] = entries_of(curved_vertex(mesh, field, std::uint32_t(v)));
    });
    fits.for_each(kSmoothReach, stage.part(0, kSmoothed),
                  [&](std::uint32_t v, const TensorFit& fit) { smoothed[v] = fit.value; });
    std::vector<CubicForm> forms = large_array<CubicForm>(mesh.size());
    std::vector<std::uint8_t> missing(mesh.size(), 1);
    fits.for_each(kDerivativeReach, stage.part(kSmoothed, 1),
                  [&](std::uint32_t v, const TensorFit& fit) {
                      forms[v] = fit.slopes;
                      missing[v] = 0;
                  });
    fill_in(mesh, field, missing, forms);
    auto& curvatures = field.smooth_curvatures;
    auto& derivatives = field.curvature_derivatives;
    curvatures = large_array(field.normals.size(), Eigen::Vector3f(Eigen::Vector3f::Zero()));
    derivatives = large_array(field.normals.size(), Eigen::Vector4f(Eigen::Vector4f::Zero()));
    for_each_element(mesh.size(), [&](std::size_t i) {
        const std::uint32_t v = mesh.original_vertex[i];
        curvatures[v] = (smoothed[i] / d).unaryExpr(&to_float);
        derivatives[v] = (forms[i].entries() / d / d).unaryExpr(&to_float);
    });
    fill_midpoint_derivatives(mesh, field);
    const std::vector<std::uint32_t>& representative = mesh.representative;
    for_each_element(representative.size(), [&](std::size_t v) {
        if (representative[v] == v) return;
        curvatures[v] = curvatures[representative[v]];
        derivatives[v] = derivatives[representative[v]];
    });
}

}  // namespace laplacian_lines
