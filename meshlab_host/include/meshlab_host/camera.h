// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "laplacian_lines/view.h"
#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

/// Column vectors: clip = projection · modelview · point.
struct CameraMatrices {
    Eigen::Matrix4d modelview = Eigen::Matrix4d::Identity();
    Eigen::Matrix4d projection = Eigen::Matrix4d::Identity();
};

/// From the GL context that is current on this thread.
CameraMatrices camera_from_gl();

bool is_orthographic(const Eigen::Matrix4d& projection);

/// How far the frustum's centre is left of and below the viewing axis, in half widths and heights.
/// Tile c of n has n - 1 - 2c, an integer.
Eigen::Vector2d frustum_offset(const Eigen::Matrix4d& projection);

/// Mesh to world coordinates.
Eigen::Matrix4d layer_transform(const CMeshO& mesh);

/// x' = factor · rotation · x; without the translation.
struct Similarity {
    Eigen::Matrix3d rotation;
    double factor;
};

/// None if the transformation stretches, shears or reflects.
std::optional<Similarity> similarity_of(const Eigen::Matrix4d& transform);

/// Refuses a layer's transformation that is singular. @throws laplacian_lines::Error(InvalidOption)
[[noreturn]] void refuse_transform();

/// The view, in mesh coordinates, of an eye in homogeneous world coordinates: (position, 1), or
/// (direction towards the viewer, 0). `to_world`, from the mesh, may scale or reflect.
/// @throws laplacian_lines::Error(InvalidOption) if it is singular
laplacian_lines::View view_from(const Eigen::Vector4d& eye, const Eigen::Matrix4d& to_world);

/// The same for the eye of a camera. Off-centre frustums (snapshot tiles) are fine.
laplacian_lines::View view_from_matrices(const Eigen::Matrix4d& modelview,
                                         const Eigen::Matrix4d& projection,
                                         const Eigen::Matrix4d& layer);

/// Towards a light that turns with the camera, 45 degrees above the plane of the picture, where
/// `azimuth` is in degrees clockwise from the top. Unit vector in eye coordinates: x right, y up, z
/// to the viewer.
Eigen::Vector3d towards_light(double azimuth);

/// From eye to mesh coordinates, not normalized. Transforms like a point at infinity, such as an
/// orthographic eye, not like a normal: so n·d = 0, n in mesh coordinates, is where the light
/// grazes the visible surface under any transformation. Empty if the product of the matrices is
/// singular.
std::optional<Eigen::Vector3d> direction_in_mesh(const Eigen::Vector3d& direction,
                                                 const Eigen::Matrix4d& modelview,
                                                 const Eigen::Matrix4d& layer);

/// The size, in views, of a picture that MeshLab composes of tiles. A tile fills the view with part
/// of the camera's frustum, so lengths in pixels have to grow with the picture.
class SnapshotTiles {
public:
    /// Tiles in a row of the picture, 1 if this is no tile. Call it at every redraw: earlier tiles
    /// identify those in the middle.
    double scale(const CameraMatrices& camera);
    /// The camera at the picture's middle: the same for all tiles, to the bit. Meaningless without
    /// tiles.
    const CameraMatrices& camera() const { return middle_; }

private:
    CameraMatrices camera_;  ///< of the last snapshot's first tile
    CameraMatrices middle_;
    double scale_ = 1;
};

}  // namespace meshlab_host
