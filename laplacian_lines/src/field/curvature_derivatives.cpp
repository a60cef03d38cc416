// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/field_steps.h"

#include <algorithm>
#include <cmath>

#include "field/midpoint_values.h"
#include "field/ring_derivatives.h"
#include "field/tensor_fits.h"
#include "system/large_array.h"

namespace laplacian_lines {
namespace {

constexpr double kLargestFloat = 1e38;
constexpr double kSmoothed = 0.3;  // of the time

/// S(u,u), S(u,v), S(v,v) of a vertex.
Eigen::Vector3d entries_of(const CurvedVertex& v) {
    const Eigen::Vector3d su = v.shape_operator * v.u, sv = v.shape_operator * v.v;
    return {v.u.dot(su), v.u.dot(sv), v.v.dot(sv)};
}

/// Of all vertices, smoothed where there is a fit.
std::vector<Eigen::Vector3d> smooth(const PreparedMesh& mesh, const Field& field,
                                    const TensorFits& fits, const StageProgress& stage) {
    std::vector<Eigen::Vector3d> smoothed = large_array<Eigen::Vector3d>(mesh.size());
    std::vector<std::uint8_t> failed(mesh.size(), 1);
    fits.for_each(kSmoothReach, stage, [&](std::uint32_t v, const TensorFit& fit) {
        smoothed[v] = fit.value;
        failed[v] = 0;
    });
    for_each_element(mesh.size(), [&](std::size_t v) {
        if (failed[v]) smoothed[v] = entries_of(curved_vertex(mesh, field, std::uint32_t(v)));
    });
    return smoothed;
}

std::vector<CubicForm> differentiate(const PreparedMesh& mesh, const VertexRanges& ranges,
                                     const Field& field, const TensorFits& fits,
                                     const StageProgress& stage) {
    std::vector<CubicForm> forms = large_array<CubicForm>(mesh.size());
    std::vector<std::uint8_t> failed(mesh.size(), 1);
    fits.for_each(kDerivativeReach, stage, [&](std::uint32_t v, const TensorFit& fit) {
        forms[v] = fit.slopes;
        failed[v] = 0;
    });
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
    const TensorFits fits(mesh, tree, field);
    const auto smoothed = smooth(mesh, field, fits, stage.part(0, kSmoothed));
    const auto forms = differentiate(mesh, ranges, field, fits, stage.part(kSmoothed, 1));
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
