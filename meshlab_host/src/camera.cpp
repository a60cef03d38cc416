// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/camera.h"

#include <Eigen/LU>
#include <cmath>

#include "laplacian_lines/error.h"

namespace meshlab_host {

bool is_orthographic(const Eigen::Matrix4d& projection) {
    // The last row makes w: (0, 0, 0, 1), or (0, 0, -1, 0) in perspective.
    return projection(3, 2) == 0;
}

Eigen::Vector2d frustum_offset(const Eigen::Matrix4d& projection) {
    // Perspective divides by -z, hence the sign.
    return is_orthographic(projection) ? Eigen::Vector2d(projection.col(3).head<2>())
                                       : Eigen::Vector2d(-projection.col(2).head<2>());
}

namespace {

void move_to_middle(Eigen::Matrix4d& projection) {
    projection.col(is_orthographic(projection) ? 3 : 2).head<2>().setZero();
}

bool is_whole(double number) {
    return std::abs(number - std::round(number)) < 1e-3;
}

/// MeshLab draws a large snapshot in n x n tiles, from the lower left on: the middle of the whole
/// is n - 1 half tiles to the right of and above that of the first.
bool is_first_tile(const Eigen::Vector2d& offset) {
    return offset.x() > 0.5 && std::abs(offset.x() - offset.y()) < 1e-3 && is_whole(offset.x());
}

}  // namespace

CameraMatrices camera_from_gl() {
    CameraMatrices camera;
    // Both OpenGL and Eigen store columns.
    glGetDoublev(GL_MODELVIEW_MATRIX, camera.modelview.data());
    glGetDoublev(GL_PROJECTION_MATRIX, camera.projection.data());
    return camera;
}

Eigen::Matrix4d layer_transform(const CMeshO& mesh) {
    Eigen::Matrix4d result;
    mesh.Tr.ToEigenMatrix(result);
    return result;
}

std::optional<Similarity> similarity_of(const Eigen::Matrix4d& transform) {
    constexpr double tolerance = 1e-4;  // MeshLab's transformations may be floats
    const Eigen::Matrix3d linear = transform.topLeftCorner<3, 3>();
    const double factor = std::cbrt(linear.determinant());
    if (!(factor > 0) || !std::isfinite(factor)) return std::nullopt;
    const Eigen::Matrix3d rotation = linear / factor;
    if (!(rotation.transpose() * rotation).isIdentity(tolerance)) return std::nullopt;
    return Similarity{rotation, factor};
}

void refuse_transform() {
    laplacian_lines::refuse(
        "The layer's transformation cannot be inverted. Reset it, or freeze it.");
}

laplacian_lines::View view_from(const Eigen::Vector4d& eye, const Eigen::Matrix4d& to_world) {
    const Eigen::Vector4d in_mesh = to_world.inverse() * eye;
    const bool is_parallel = eye.w() == 0;
    if (!in_mesh.allFinite() || in_mesh.isZero(0) || (!is_parallel && in_mesh.w() == 0))
        refuse_transform();
    const Eigen::Vector3d direction = in_mesh.head<3>();
    return is_parallel ? laplacian_lines::View::orthographic(direction.normalized())
                       : laplacian_lines::View::perspective(direction / in_mesh.w());
}

laplacian_lines::View view_from_matrices(const Eigen::Matrix4d& modelview,
                                         const Eigen::Matrix4d& projection,
                                         const Eigen::Matrix4d& layer) {
    // In eye coordinates the eye is the origin, or infinitely far along +z.
    const bool is_parallel = is_orthographic(projection);
    return view_from(is_parallel ? Eigen::Vector4d::UnitZ() : Eigen::Vector4d::UnitW(),
                     modelview * layer);
}

Eigen::Vector3d towards_light(double azimuth) {
    const double degree = std::acos(-1.0) / 180, elevation = 45 * degree;
    return {std::cos(elevation) * std::sin(azimuth * degree),
            std::cos(elevation) * std::cos(azimuth * degree), std::sin(elevation)};
}

std::optional<Eigen::Vector3d> direction_in_mesh(const Eigen::Vector3d& direction,
                                                 const Eigen::Matrix4d& modelview,
                                                 const Eigen::Matrix4d& layer) {
    const Eigen::Matrix3d to_mesh = (modelview * layer).topLeftCorner<3, 3>().inverse();
    const Eigen::Vector3d result = to_mesh * direction;
    if (!result.allFinite() || !(result.norm() > 0)) return std::nullopt;
    return result;
}

double SnapshotTiles::scale(const CameraMatrices& camera) {
    // Asked first: an inner tile can look like the first one of fewer.
    const Eigen::Vector4d zoom = camera.projection.diagonal(),
                          earlier = camera_.projection.diagonal();
    const bool is_next = scale_ > 1 && camera.modelview.isApprox(camera_.modelview, 1e-6) &&
                         zoom.head<2>().isApprox(earlier.head<2>(), 1e-5);
    if (is_next) return scale_;
    const Eigen::Vector2d place = frustum_offset(camera.projection);
    if (!is_first_tile(place)) return 1;
    camera_ = middle_ = camera;
    move_to_middle(middle_.projection);
    scale_ = 1 + std::round(place.x());
    return scale_;
}

}  // namespace meshlab_host
