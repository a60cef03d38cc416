// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"
#include "laplacian_lines/view.h"
#include "line_drawing/view_frame.h"
#include "planes/clipping.h"

namespace line_drawing {

/// From mesh coordinates to a picture, x right, y up, with `middle` at (0, 0). A perspective one is
/// as large as the object is where it is as far from the eye as `middle`.
class Projection {
public:
    Projection(const ViewFrame& frame, const Eigen::Vector3d& middle);

    Eigen::Vector2d operator()(const Eigen::Vector3d& p) const;

    /// What the triangles of a mesh take in the picture; of a perspective one, at least what is in
    /// sight. Empty if all is behind the eye.
    Eigen::AlignedBox2d boundsOf(const laplacian_lines::TriangleMesh& mesh) const;

    /// Lines as far as they are in sight: all of a parallel view.
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
