// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>

#include "line_renderer/surface.h"

namespace line_renderer {

/// A surface in its place.
struct SurfaceLayer {
    std::weak_ptr<const Surface> surface;
    Eigen::Matrix4d transform = Eigen::Matrix4d::Identity();  ///< mesh to world coordinates
    double diagonal = 0;                                      ///< of the mesh, mesh units
    bool culls_back_faces = false;
    /// MeshLab's depth buffer holds the faces and nothing before them.
    bool is_in_depth_buffer = false;

    bool operator==(const SurfaceLayer& other) const {
        return !surface.owner_before(other.surface) && !other.surface.owner_before(surface) &&
               transform == other.transform && culls_back_faces == other.culls_back_faces &&
               is_in_depth_buffer == other.is_in_depth_buffer;
    }
    bool operator!=(const SurfaceLayer& other) const { return !(*this == other); }
};

}  // namespace line_renderer
