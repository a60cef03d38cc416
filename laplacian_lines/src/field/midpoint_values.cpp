// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices that undone subdivisions had added get the mean of what is at the ends of their edges.
// Numbers that belong to a tangent frame are turned into that of the midpoint first: curvatures by
// twice the angle between the frames, their derivatives as CubicForm does.
#include "field/field_steps.h"

#include <algorithm>
#include <complex>

#include "field/cubic_form.h"
#include "laplacian_lines/tangent_frame.h"

namespace laplacian_lines {
namespace {

ShapeOperator mean(const ShapeOperator& a, const ShapeOperator& b) {
    return {(a.xx + b.xx) / 2, (a.yy + b.yy) / 2, (a.zz + b.zz) / 2,
            (a.yz + b.yz) / 2, (a.xz + b.xz) / 2, (a.xy + b.xy) / 2};
}

/// Calls fill for each midpoint, from the last on: their ends may be later midpoints.
template <class Fill>
void for_each_midpoint(const PreparedMesh& mesh, Fill fill) {
    std::for_each(mesh.midpoints.rbegin(), mesh.midpoints.rend(), fill);
}

/// The first direction of a frame, projected to the plane of another one.
std::complex<double> direction_in(const TangentFrame& from, const TangentFrame& to) {
    const Eigen::Vector2f u = from(to.u);
    const std::complex<double> direction(double(u.x()), double(u.y()));
    const double length = std::abs(direction);
    return length > 0 ? direction / length : 1;
}

/// uu, uv, vv in a frame whose first direction is `d` in the old one.
Eigen::Vector3d turned(const Eigen::Vector3d& s, std::complex<double> d) {
    const std::complex<double> double_angle = d * d;
    const double mean = (s[0] + s[2]) / 2;
    const std::complex<double> rest =
        std::complex<double>((s[0] - s[2]) / 2, s[1]) * std::conj(double_angle);
    return {mean + rest.real(), rest.imag(), mean - rest.real()};
}

}  // namespace

void fill_midpoints(const PreparedMesh& mesh, Field& field) {
    for_each_midpoint(mesh, [&](const Midpoint& m) {
        const auto [a, b] = m.ends;
        const Eigen::Vector3f n = field.normals[a] + field.normals[b];
        field.normals[m.vertex] = n.isZero(0) ? field.normals[a] : n.stableNormalized();
        field.laplacian_normals[m.vertex] =
            field.laplacian_normals[a] / 2 + field.laplacian_normals[b] / 2;
        field.shape_operators[m.vertex] = mean(field.shape_operators[a], field.shape_operators[b]);
    });
}

void fill_midpoint_derivatives(const PreparedMesh& mesh, Field& field) {
    for_each_midpoint(mesh, [&](const Midpoint& m) {
        const TangentFrame to = tangent_frame(field.normals[m.vertex]);
        Eigen::Vector3d curvature = Eigen::Vector3d::Zero();
        CubicForm derivative{};
        for (const std::uint32_t end : m.ends) {
            const auto direction = direction_in(tangent_frame(field.normals[end]), to);
            curvature += turned(field.smooth_curvatures[end].cast<double>(), direction) / 2;
            const Eigen::Vector4d c = field.curvature_derivatives[end].cast<double>();
            derivative.add(CubicForm::of(c[0], c[1], c[2], c[3]).turned(std::conj(direction)), 0.5);
        }
        field.smooth_curvatures[m.vertex] = curvature.cast<float>();
        field.curvature_derivatives[m.vertex] = derivative.entries().cast<float>();
    });
}

}  // namespace laplacian_lines
