// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/camera.h"

#include <Eigen/LU>
#include <cmath>

namespace meshlab_host {

Eigen::Matrix4d layerTransform(const CMeshO& mesh) {
    Eigen::Matrix4d result;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            result(row, column) = double(mesh.Tr[row][column]);
    return result;
}

bool isOrthographic(const Eigen::Matrix4d& projection) {
    // The last row makes w: (0, 0, 0, 1), or (0, 0, -1, 0) in perspective.
    return projection(3, 2) == 0;
}

std::optional<laplacian_lines::View> viewFromMatrices(const Eigen::Matrix4d& modelview,
                                                      const Eigen::Matrix4d& projection,
                                                      const Eigen::Matrix4d& layer) {
    const Eigen::Matrix4d to_mesh = (modelview * layer).inverse();
    if (!to_mesh.allFinite()) return std::nullopt;
    // The eye is the origin of eye coordinates, or infinitely far along +z.
    if (isOrthographic(projection)) {
        const Eigen::Vector3d towards_viewer = to_mesh.col(2).head<3>();
        if (!(towards_viewer.norm() > 0)) return std::nullopt;
        return laplacian_lines::View::orthographic(towards_viewer.normalized());
    }
    if (to_mesh(3, 3) == 0) return std::nullopt;
    return laplacian_lines::View::perspective(to_mesh.col(3).head<3>() / to_mesh(3, 3));
}

std::optional<laplacian_lines::View> viewFromWorld(const Eigen::Vector4d& eye,
                                                   const Eigen::Matrix4d& layer) {
    const Eigen::Vector4d in_mesh = layer.inverse() * eye;
    if (!in_mesh.allFinite() || in_mesh.isZero(0)) return std::nullopt;
    const Eigen::Vector3d direction = in_mesh.head<3>();
    if (in_mesh.w() == 0) return laplacian_lines::View::orthographic(direction.normalized());
    return laplacian_lines::View::perspective(direction / in_mesh.w());
}

Eigen::Vector3d towardsLight(double azimuth) {
    const double degree = std::acos(-1.0) / 180, elevation = 45 * degree;
    return {std::cos(elevation) * std::sin(azimuth * degree),
            std::cos(elevation) * std::cos(azimuth * degree), std::sin(elevation)};
}

std::optional<Eigen::Vector3d> directionInMesh(const Eigen::Vector3d& direction,
                                               const Eigen::Matrix4d& modelview,
                                               const Eigen::Matrix4d& layer) {
    const Eigen::Matrix3d to_mesh = (modelview * layer).topLeftCorner<3, 3>().inverse();
    const Eigen::Vector3d result = to_mesh * direction;
    if (!result.allFinite() || !(result.norm() > 0)) return std::nullopt;
    return result;
}

}  // namespace meshlab_host
