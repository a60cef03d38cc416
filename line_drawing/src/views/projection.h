// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"
#include "laplacian_lines/view.h"
#include "line_drawing/view_frame.h"
#include "planes/clipping.h"

namespace line_drawing {

/// From mesh coordinates to a picture, x right, y up, with `middle` at (0, 0), where perspective
/// has the scale 1.
class Projection {
public:
    Projection(const ViewFrame& frame, const Eigen::Vector3d& middle);

    Eigen::Vector2d operator()(const Eigen::Vector3d& p) const;

    /// Of the triangles in the picture; in perspective at least of what is in sight, empty if all
    /// is behind the eye.
    Eigen::AlignedBox2d boundsOf(const laplacian_lines::TriangleMesh& mesh) const;

    /// Clipped to what is in sight; all in a parallel view.
    std::vector<laplacian_lines::SightLine> inSight(
        std::vector<laplacian_lines::SightLine> lines) const;

    laplacian_lines::View view() const;

private:
    double depth(const Eigen::Vector3d& p) const;

    const ViewFrame& frame_;
    Eigen::Vector3d origin_;           // the eye, or what is at (0, 0)
    double distance_ = 0;              // of `middle` from the eye
    Eigen::Vector2d middle_ = {0, 0};  // in the picture, from the point before the eye
};

}  // namespace line_drawing
