// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"
#include "laplacian_lines/view.h"

namespace benchmarks {

/// The mesh without the triangles that are left out of a drawing: those with a corner that is not
/// finite, and those without area.
laplacian_lines::TriangleMesh without_unusable(const laplacian_lines::TriangleMesh& mesh);

/// From `count` directions evenly around a mesh, every second one in perspective, from 1.25 D.
std::vector<laplacian_lines::View> views_around(const laplacian_lines::TriangleMesh& mesh,
                                                int count);

/// Shows a whole mesh in the middle of a square picture, y upwards where that can be.
class PictureCamera {
public:
    /// `size` in pixels; the mesh takes `filled` of it in width or in height.
    /// @throws std::invalid_argument if a corner of a triangle is not in front of the eye.
    PictureCamera(const laplacian_lines::View& view, const laplacian_lines::TriangleMesh& mesh,
                  int size, double filled = 0.8);

    /// Column and row in pixels, from the upper left corner of the picture, and the depth along the
    /// axis of sight in mesh units.
    Eigen::Vector3d project(const Eigen::Vector3d& point) const;
    /// What is affine on the picture of a plane, growing with the depth; and back.
    double affine_depth(double depth) const { return is_perspective() ? -1 / depth : depth; }
    double true_depth(double affine) const { return is_perspective() ? -1 / affine : affine; }

    int size() const { return size_; }
    bool is_perspective() const { return view_.w != 0; }
    const Eigen::Vector3d& position() const { return position_; }
    const laplacian_lines::View& view() const { return view_; }

private:
    /// Right, up and depth as the eye sees them, before they are brought into the picture.
    Eigen::Vector3d seen(const Eigen::Vector3d& point) const;

    laplacian_lines::View view_;
    int size_;
    Eigen::Vector3d position_;  // of the eye, or for orthographic views a place to measure from
    Eigen::Matrix3d axes_;      // rows: right, up, away from the eye
    double scale_ = 1;
    Eigen::Vector2d middle_ = Eigen::Vector2d::Zero();
};

}  // namespace benchmarks
