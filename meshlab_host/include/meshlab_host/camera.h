// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "laplacian_lines/view.h"
#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

/// OpenGL's matrices, column vectors: clip = projection · modelview · point.
struct CameraMatrices {
    Eigen::Matrix4d modelview = Eigen::Matrix4d::Identity();
    Eigen::Matrix4d projection = Eigen::Matrix4d::Identity();
};

/// The matrices of the current GL context, which must be current on this thread.
CameraMatrices cameraFromGl();

/// The transformation of a layer: mesh coordinates to world coordinates.
Eigen::Matrix4d layerTransform(const CMeshO& mesh);

/// Whether a projection has parallel rays of sight.
bool isOrthographic(const Eigen::Matrix4d& projection);

/// The eye in the coordinates of a mesh whose layer has the transformation `layer`; any invertible
/// one will do, also with unequal scales or a reflection. Off-centre frustums (snapshot tiles) are
/// fine. Empty if the product of the matrices cannot be inverted.
std::optional<laplacian_lines::View> viewFromMatrices(const Eigen::Matrix4d& modelview,
                                                      const Eigen::Matrix4d& projection,
                                                      const Eigen::Matrix4d& layer);

/// The same for an eye in homogeneous world coordinates: (position, 1), or (direction towards the
/// viewer, 0) for an orthographic camera.
std::optional<laplacian_lines::View> viewFromWorld(const Eigen::Vector4d& eye,
                                                   const Eigen::Matrix4d& layer);

/// Where a light stands that turns with the camera, in degrees. The defaults light a find the way
/// that archaeologists draw it.
struct CameraLight {
    double azimuth = 315;   ///< in the picture, clockwise from the top: 90 right, 270 left
    double elevation = 45;  ///< 90: right behind the viewer, 0: in the plane of the picture
};

/// The unit vector towards the light in eye coordinates: x to the right, y up, z to the viewer.
Eigen::Vector3d towardsLight(const CameraLight& light);

/// A direction from eye coordinates in those of a mesh, not normalized. It is moved as the point at
/// infinity that it leads to, like the eye of an orthographic camera, not as a normal: so, whatever
/// the transformations do to angles, n·d = 0 (n in mesh coordinates) is where rays of such a light
/// graze the surface that is seen. Empty if the product of the matrices cannot be inverted.
std::optional<Eigen::Vector3d> directionInMesh(const Eigen::Vector3d& direction,
                                               const Eigen::Matrix4d& modelview,
                                               const Eigen::Matrix4d& layer);

}  // namespace meshlab_host
