// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "laplacian_lines/triangle_mesh.h"
#include "laplacian_lines/view.h"
#include "visibility/sight_mesh.h"

namespace laplacian_lines {

/// How a view looks at a mesh, in its local coordinates: the axes of the picture, x right, y up,
/// and the eye of a perspective view.
///
/// Ties, such as faces seen along their planes and edges one behind the other, cannot be: the eye
/// is turned around the object by 3e-5 rad, about an axis in no special direction, and all that is
/// decided is decided from there (H. Edelsbrunner, E. Mücke, "Simulation of Simplicity", 1990, by
/// one fixed step). What is drawn keeps its place in space.
class EyeFrame {
public:
    /// A perspective eye looks towards the middle of the mesh, or away from it.
    EyeFrame(const SightMesh& mesh, const View& view, bool looks_away = false);

    /// By which the eye is turned, rad.
    static double turn();

    bool has_perspective() const { return has_perspective_; }

    /// Unit.
    Eigen::Vector3d towards_eye(const Eigen::Vector3d& local) const {
        return has_perspective_ ? Eigen::Vector3d((eye_ - local).stableNormalized()) : back_;
    }
    /// Along the axis of sight of a perspective eye, local.
    double depth(const Eigen::Vector3d& local) const { return back_.dot(eye_ - local); }

    /// In the picture, with z larger where it is nearer. A perspective view is made parallel by
    /// z = 1 / depth, which keeps planes and straight lines.
    Eigen::Vector3d place(const Eigen::Vector3d& local) const;

private:
    Eigen::Vector3d eye_, right_, up_, back_;
    bool has_perspective_;
};

/// Perspective views show what is so far before the eye, local.
constexpr double kLeastDepth = 1e-5;

/// Whether all of a mesh is before the eye.
bool is_before_eye(const SightMesh& mesh, const EyeFrame& frame);

/// The part of a mesh that is before a perspective eye, cut off at kLeastDepth; local.
TriangleMesh part_before_eye(const SightMesh& mesh, const EyeFrame& frame);

}  // namespace laplacian_lines
