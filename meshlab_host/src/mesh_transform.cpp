// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/mesh_transform.h"

#include <Eigen/LU>
#include <utility>

#include "laplacian_lines/precompute.h"

namespace meshlab_host {

using laplacian_lines::Field;
using laplacian_lines::ShapeOperator;
using laplacian_lines::TriangleMesh;

namespace {

Eigen::Matrix3f matrix_of(const ShapeOperator& s) {
    Eigen::Matrix3f matrix;
    matrix << s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz;
    return matrix;
}

ShapeOperator shape_operator_of(const Eigen::Matrix3f& m) {
    return {m(0, 0), m(1, 1), m(2, 2), m(1, 2), m(0, 2), m(0, 1)};
}

}  // namespace

void apply_transform(const Eigen::Matrix4d& layer, TriangleMesh& mesh) {
    const Eigen::Matrix3d linear = layer.topLeftCorner<3, 3>();
    const double determinant = linear.determinant();
    if (determinant == 0 || !layer.allFinite()) refuse_transform();
    for (Eigen::Vector3d& p : mesh.positions)
        p = linear * p + layer.topRightCorner<3, 1>();
    const Eigen::Matrix3d of_normals = linear.inverse().transpose();
    for (Eigen::Vector3d& n : mesh.normals)
        n = (of_normals * n).stableNormalized();
    mesh.known_edge *= laplacian_lines::mean_scale(layer);
    if (determinant < 0)
        for (laplacian_lines::Triangle& triangle : mesh.triangles)
            std::swap(triangle[1], triangle[2]);
}

void apply_transform(const Similarity& similarity, Field& field) {
    const Eigen::Matrix3f rotation = similarity.rotation.cast<float>();
    const auto factor = float(similarity.factor);
    for (Eigen::Vector3f& n : field.normals)
        n = (rotation * n).eval();
    for (Eigen::Vector3f& n : field.laplacian_normals)
        n = (rotation * n / (factor * factor)).eval();
    for (ShapeOperator& s : field.shape_operators)
        s = shape_operator_of(rotation * matrix_of(s) * rotation.transpose() / factor);
    field.smooth_curvatures.clear();
    field.curvature_derivatives.clear();
    for (double* length : {&field.scale.diagonal, &field.scale.mean_edge, &field.scale.kernel_size,
                           &field.scale.normal_sigma})
        *length *= similarity.factor;
}

void apply_transform(const Eigen::Matrix4d& layer, laplacian_lines::PrecomputeOptions options,
                     TriangleMesh& mesh, std::optional<Field>& field,
                     const laplacian_lines::Progress& progress) {
    if (layer.isIdentity(0)) return;
    apply_transform(layer, mesh);
    if (!field) return;
    if (const std::optional<Similarity> similarity = similarity_of(layer))
        return apply_transform(*similarity, *field);
    options.kernel_size *=
        laplacian_lines::mean_scale(layer);  // lengths now depend on the direction
    field = laplacian_lines::precompute(mesh, options, progress);
}

}  // namespace meshlab_host
