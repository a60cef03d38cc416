// SPDX-License-Identifier: GPL-3.0-or-later
#include "plain_derivatives.h"

#include <Eigen/Dense>
#include <cmath>

#include "laplacian_lines/tangent_frame.h"
#include "reference_field.h"

namespace reference {

using namespace laplacian_lines;

namespace {

constexpr double kReach = 3.4;  // √h
using Entries = Eigen::Matrix<double, 3, 3>;

Eigen::Vector3d entries_of(const ShapeOperator& s, const TangentFrame& frame) {
    return Eigen::Vector3f(frame.u.dot(s * frame.u), frame.u.dot(s * frame.v),
                           frame.v.dot(s * frame.v))
        .cast<double>();
}

Eigen::Vector4d derivative_at(std::size_t v, const TriangleMesh& mesh, const Field& field,
                              const std::vector<double>& masses) {
    const TangentFrame frame = tangent_frame(field.normals[v]);
    const double radius = kReach * double(field.kernel_sizes[v]);
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
    const Entries slopes = products.ldlt().solve(moments);
    return {slopes(1, 0), (slopes(2, 0) + 2 * slopes(1, 1)) / 3,
            (slopes(1, 2) + 2 * slopes(2, 1)) / 3, slopes(2, 2)};
}

}  // namespace

std::vector<Eigen::Vector4d> curvature_derivatives(const TriangleMesh& mesh, const Field& field) {
    const std::vector<double> mass = masses(mesh);
    std::vector<Eigen::Vector4d> derivatives;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        derivatives.push_back(derivative_at(v, mesh, field, mass));
    return derivatives;
}

}  // namespace reference
