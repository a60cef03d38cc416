// SPDX-License-Identifier: GPL-3.0-or-later
#include "plain_derivatives.h"

#include <Eigen/Dense>

#include "laplacian_lines/tangent_frame.h"
#include "reference_field.h"

namespace reference {

using namespace laplacian_lines;

namespace {

constexpr double kReach = 3.4, kSmoothReach = 1.4;  // √h
using Entries = Eigen::Matrix<double, 3, 3>;

Eigen::Vector3d entries_of(const ShapeOperator& s, const TangentFrame& frame) {
    return Eigen::Vector3f(frame.u.dot(s * frame.u), frame.u.dot(s * frame.v),
                           frame.v.dot(s * frame.v))
        .cast<double>();
}

/// S(u,u), S(u,v), S(v,v), one a column, and their slopes along u and along v.
Entries fit_at(std::size_t v, double reach, const TriangleMesh& mesh, const Field& field,
               const std::vector<double>& masses) {
    const TangentFrame frame = tangent_frame(field.normals[v]);
    const double radius = reach * double(field.kernel_sizes[v]);
    Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
    Entries moments = Entries::Zero();  // rows by 1, x, y; columns by the entry of S
    for (std::size_t q = 0; q < mesh.positions.size(); ++q) {
        const Eigen::Vector3d d = mesh.positions[q] - mesh.positions[v];
        const double inside = 1 - d.squaredNorm() / (radius * radius);
        if (!(inside > 0)) continue;
        const double cosine = double(field.normals[q].dot(field.normals[v]));
        const double weight =
            masses[q] * inside * inside * ((1 + cosine) * (1 + cosine) * (2 - cosine) / 4);
        const Eigen::Vector3d at(1, frame.u.cast<double>().dot(d), frame.v.cast<double>().dot(d));
        products += weight * at * at.transpose();
        moments += weight * at * entries_of(field.shape_operators[q], frame).transpose();
    }
    return products.ldlt().solve(moments);
}

}  // namespace

PlainDerivatives curvature_derivatives(const TriangleMesh& mesh, const Field& field) {
    const std::vector<double> mass = masses(mesh);
    PlainDerivatives result;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const Entries c = fit_at(v, kReach, mesh, field, mass);
        result.derivatives.emplace_back(c(1, 0), (c(2, 0) + 2 * c(1, 1)) / 3,
                                        (c(1, 2) + 2 * c(2, 1)) / 3, c(2, 2));
        result.curvatures.push_back(fit_at(v, kSmoothReach, mesh, field, mass).row(0));
    }
    return result;
}

}  // namespace reference
