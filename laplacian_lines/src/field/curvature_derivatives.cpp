// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/curvature_derivatives.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "field/cubic_form.h"
#include "field/symmetric_tensor.h"
#include "laplacian_lines/tangent_frame.h"
#include "system/large_array.h"

namespace laplacian_lines {
namespace {

constexpr double kLargestFloat = 1e38;
/// Between a triangle's normal and those of its corners: beyond that S is of another side.
constexpr double kLeastCosine = 0.1;

/// A vertex of the field in local units.
struct Vertex {
    Eigen::Vector3d normal, u, v;  ///< orthonormal
    SymmetricTensor shape_operator;
};

using Vertices = std::vector<Vertex>;
using CubicForms = std::vector<CubicForm>;

Vertex vertex_of(const Field& field, std::size_t v, double diagonal) {
    const Eigen::Vector3f& n = field.normals[v];
    const TangentFrame frame = tangent_frame(n);
    const ShapeOperator& s = field.shape_operators[v];
    SymmetricTensor local = {s.xx, s.yy, s.zz, s.yz, s.xz, s.xy};
    local.scale(diagonal);
    return {n.cast<double>(), frame.u.cast<double>(), frame.v.cast<double>(), local};
}

/// In the plane of a triangle with unit normal n.
struct PlaneFrame {
    Eigen::Vector3d n, t, b;  // orthonormal

    /// Turned with the plane from n to m, the shortest way.
    PlaneFrame turned_to(const Eigen::Vector3d& m) const {
        const Eigen::Vector3d middle = (n + m) / (1 + n.dot(m));
        return {m, t - t.dot(m) * middle, b - b.dot(m) * middle};
    }
};

/// The derivative of S, linear between the corners of a triangle, in the triangle's plane; made
/// symmetric, as it is on smooth surfaces (Codazzi). S. Rusinkiewicz, "Estimating Curvatures and
/// Their Derivatives on Triangle Meshes", 3DPVT 2004, section 4, without its least squares.
class TriangleDerivative {
public:
    /// False if the triangle has no part in the derivatives.
    bool fit(const Eigen::Vector3d* const p[3], const Vertex* const corners[3]) {
        const Eigen::Vector3d edges[3] = {*p[2] - *p[1], *p[0] - *p[2], *p[1] - *p[0]};
        const Eigen::Vector3d area = edges[2].cross(-edges[1]);
        weight_ = area.norm();
        const double longest = edges[0].norm();
        if (!(weight_ > 0 && longest > 0)) return false;
        PlaneFrame plane;
        plane.n = area / weight_;
        plane.t = edges[0] / longest;
        plane.b = plane.n.cross(plane.t);
        // Derivatives along t and b of S(t, t), S(t, b), S(b, b), times the weight.
        double by_t[3] = {}, by_b[3] = {};
        for (int k = 0; k < 3; ++k) {
            const Vertex& corner = *corners[k];
            if (!(plane.n.dot(corner.normal) > kLeastCosine)) return false;
            const PlaneFrame turned = plane.turned_to(corner.normal);
            const Eigen::Vector3d st = corner.shape_operator * turned.t,
                                  sb = corner.shape_operator * turned.b;
            const double entries[3] = {turned.t.dot(st), turned.b.dot(st), turned.b.dot(sb)};
            for (int i = 0; i < 3; ++i) {
                by_t[i] -= edges[k].dot(plane.b) * entries[i];
                by_b[i] += edges[k].dot(plane.t) * entries[i];
            }
            first_directions_[k] = {turned.t.dot(corner.u), turned.t.dot(corner.v)};
        }
        form_ = CubicForm::of(by_t[0], (by_b[0] + 2 * by_t[1]) / 3, (by_t[2] + 2 * by_b[1]) / 3,
                              by_b[2]);
        return true;
    }

    double weight() const { return weight_; }  ///< twice the area
    /// Times the weight, in the frame of a corner.
    CubicForm at(int corner) const { return form_.turned(first_directions_[corner]); }

private:
    double weight_ = 0;
    CubicForm form_;
    std::complex<double> first_directions_[3];
};

CubicForms differentiate(const PreparedMesh& mesh, const VertexRanges& ranges,
                         const Vertices& vertices, const StageProgress& stage) {
    CubicForms forms = large_array<CubicForm>(mesh.size());
    std::vector<double> weights = large_array(mesh.size(), 0.);
    ranges.for_each(stage, [&](const VertexRanges::Range& range) {
        range.prefetch(mesh.positions);
        range.prefetch(vertices);
        TriangleDerivative derivative;
        range.for_each_triangle([&](const Triangle& t) {
            const Eigen::Vector3d* const p[3] = {&mesh.positions[t[0]], &mesh.positions[t[1]],
                                                 &mesh.positions[t[2]]};
            const Vertex* const corners[3] = {&vertices[t[0]], &vertices[t[1]], &vertices[t[2]]};
            if (!derivative.fit(p, corners)) return;
            for (int k = 0; k < 3; ++k) {
                if (!range.holds(t[k])) continue;
                forms[t[k]].add(derivative.at(k), 1);
                weights[t[k]] += derivative.weight();
            }
        });
        for (std::uint32_t v = range.begin(); v < range.end(); ++v)
            if (weights[v] > 0) forms[v].scale(1 / weights[v]);
    });
    return forms;
}

float to_float(double x) {
    return std::isfinite(x) ? float(std::clamp(x, -kLargestFloat, kLargestFloat)) : 0.f;
}

}  // namespace

void fill_curvature_derivatives(const PreparedMesh& mesh, const VertexRanges& ranges,
                                const StageProgress& stage, Field& field) {
    const double d = mesh.diagonal;
    Vertices vertices = large_array<Vertex>(mesh.size());
    for_each_element(mesh.size(), [&](std::size_t i) {
        vertices[i] = vertex_of(field, mesh.original_vertex[i], d);
    });
    const CubicForms forms = differentiate(mesh, ranges, vertices, stage);
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
