// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "laplacian_lines/triangle_mesh.h"
#include "laplacian_lines/view.h"
#include "visibility/visibility_mesh.h"

namespace laplacian_lines {

/// The camera of a view in local coordinates: the axes of the picture, x right, y up, and the eye
/// of a perspective view. The eye is turned around the object by 3e-5 rad about an arbitrary axis,
/// so that degenerate cases, such as faces seen edge-on, cannot occur (H. Edelsbrunner, E. Mücke,
/// "Simulation of Simplicity", 1990, by one fixed step). Lines keep their places in space.
class EyeFrame {
public:
    /// A perspective eye, at most 1e8 D away, looks towards the centre of the mesh or away from it.
    EyeFrame(const VisibilityMesh& mesh, const View& view, bool looks_away = false);

    /// By how much the eye is turned, rad.
    static double turn();

    bool has_perspective() const { return has_perspective_; }

    /// Unit.
    Eigen::Vector3d towards_eye(const Eigen::Vector3d& local) const {
        return has_perspective_ ? Eigen::Vector3d((eye_ - local).stableNormalized()) : back_;
    }
    /// Distance in front of a perspective eye, along its axis, local.
    double depth(const Eigen::Vector3d& local) const { return back_.dot(eye_ - local); }

    /// Projects to the picture, z growing towards the eye. In perspective z = 1 / depth, so that
    /// planes and straight lines stay so and the projection along z is parallel.
    Eigen::Vector3d project(const Eigen::Vector3d& local) const;

private:
    Eigen::Vector3d eye_, right_, up_, back_;
    bool has_perspective_;
};

/// Depth of the near plane of a perspective eye, local.
constexpr double kLeastDepth = 1e-5;

/// Whether all of a mesh is before the eye.
bool is_before_eye(const VisibilityMesh& mesh, const EyeFrame& frame);

/// The mesh clipped at kLeastDepth; local.
TriangleMesh part_before_eye(const VisibilityMesh& mesh, const EyeFrame& frame);

}  // namespace laplacian_lines
