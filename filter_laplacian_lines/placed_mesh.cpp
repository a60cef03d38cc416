// SPDX-License-Identifier: GPL-3.0-or-later
#include "placed_mesh.h"

#include <Eigen/LU>
#include <cmath>
#include <utility>

#include "laplacian_lines/error.h"

using laplacian_lines::Field;
using laplacian_lines::ShapeOperator;

namespace {

/// MeshLab's transformations are floats.
constexpr double tolerance = 1e-4;

Eigen::Matrix3f matrixOf(const ShapeOperator& s) {
    Eigen::Matrix3f matrix;
    matrix << s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz;
    return matrix;
}

ShapeOperator shapeOperatorOf(const Eigen::Matrix3f& m) {
    return {m(0, 0), m(1, 1), m(2, 2), m(1, 2), m(0, 2), m(0, 1)};
}

}  // namespace

std::optional<Similarity> similarityOf(const Eigen::Matrix4d& layer) {
    const Eigen::Matrix3d linear = layer.topLeftCorner<3, 3>();
    const double factor = std::cbrt(linear.determinant());
    if (!(factor > 0) || !std::isfinite(factor)) return std::nullopt;
    const Eigen::Matrix3d rotation = linear / factor;
    if (!(rotation.transpose() * rotation).isIdentity(tolerance)) return std::nullopt;
    return Similarity{rotation, factor};
}

void place(const Eigen::Matrix4d& layer, laplacian_lines::TriangleMesh& mesh) {
    const Eigen::Matrix3d linear = layer.topLeftCorner<3, 3>();
    const double determinant = linear.determinant();
    if (determinant == 0 || !layer.allFinite())
        laplacian_lines::refuse(
            "The layer's transformation cannot be inverted. Reset it, or freeze it.");
    for (Eigen::Vector3d& p : mesh.positions)
        p = linear * p + layer.topRightCorner<3, 1>();
    if (determinant < 0)
        for (laplacian_lines::Triangle& triangle : mesh.triangles)
            std::swap(triangle[1], triangle[2]);
}

void place(const Similarity& similarity, Field& field) {
    const Eigen::Matrix3f rotation = similarity.rotation.cast<float>();
    const auto factor = float(similarity.factor);
    for (Eigen::Vector3f& n : field.normals)
        n = (rotation * n).eval();
    for (Eigen::Vector3f& n : field.laplacian_normals)
        n = (rotation * n / (factor * factor)).eval();
    for (ShapeOperator& s : field.shape_operators)
        s = shapeOperatorOf(rotation * matrixOf(s) * rotation.transpose() / factor);
    field.smooth_curvatures.clear();
    field.curvature_derivatives.clear();
    for (float& size : field.kernel_sizes)
        size *= factor;
    for (double* length : {&field.scale.diagonal, &field.scale.mean_edge, &field.scale.kernel_size,
                           &field.scale.normal_sigma})
        *length *= similarity.factor;
}
