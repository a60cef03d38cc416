// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/triangle_mesh.h"
#include "line_drawing/sheet.h"
#include "plane_lines.h"

namespace benchmarks {

constexpr double flatness = 0.002;  // mm, of curves as they are measured

/// A line of a measured drawing.
struct DrawnPath {
    PlaneLine points;
    bool is_outline = false;  ///< it is on the layer of outlines
    bool is_closed = false;
};
using DrawnPaths = std::vector<DrawnPath>;

PlaneLines lines_of(const DrawnPaths& paths);

/// At 1:1, with plain strokes.
struct DrawingSetup {
    double mm_per_unit = 1;
    Eigen::Vector3d origin = {0, 0, 0};  ///< of the pictures' coordinates, in those of the mesh
};

/// makeSheets() of contours, borders and creases: a drawing for each frame, in its coordinates.
/// @throws laplacian_lines::Error
std::vector<DrawnPaths> drawings_of(const laplacian_lines::TriangleMesh& mesh,
                                    const std::vector<PlaneFrame>& frames,
                                    const DrawingSetup& setup = {});

/// A view's lines, flattened to .002 mm, in the sheet's coordinates, y down.
DrawnPaths flattened(const line_drawing::SheetGroup& view);

}  // namespace benchmarks
