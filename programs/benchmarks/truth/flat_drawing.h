// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/triangle_mesh.h"
#include "line_drawing/view_frame.h"
#include "plane_lines.h"

namespace benchmarks {

inline PlanePoint project(const Eigen::Vector3d& p, const line_drawing::ViewFrame& frame) {
    return {p.dot(frame.right), p.dot(frame.up)};
}

/// Measured drawings at 1:1 of contours, borders and creases with plain strokes: for each frame the
/// lines in its coordinates, curves to .002 mm. @throws laplacian_lines::Error
std::vector<PlaneLines> drawings_of(const laplacian_lines::TriangleMesh& mesh,
                                    const std::vector<line_drawing::ViewFrame>& frames);

}  // namespace benchmarks
