// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "depth_picture.h"
#include "laplacian_lines/line_style.h"
#include "laplacian_lines/view.h"
#include "line_picture.h"
#include "pixel_mask.h"

namespace benchmarks {

/// Within so many pixels, a line draws what is there.
constexpr double kReach = 3;
/// What counts as a jump: of the depth, in D, and of the normals, in degrees.
constexpr double kDepthJump = 0.01, kNormalJump = 20;

struct MeasureOptions {
    laplacian_lines::LineStyle style;
    int views = 12;
    int size = 400;          ///< of the picture, in pixels
    double edge_angle = 40;  ///< least angle of an edge that should be drawn, degrees
};

/// Pixels of the outline that have a line near them.
Share drawn(const PixelMask& wanted, const PixelMask& lines);
/// Pixels of lines that have neither a jump of depth or normals near them nor the place where
/// surface and background meet. `diagonal` is D.
Share strays(const DepthPicture& surface, const PixelMask& lines, double diagonal);

/// One view of a mesh: what is there, and what is drawn.
struct DrawnView {
    PixelMask surface, outline, lines;
};

struct ViewMeasures {
    Share outline, strays, edges;
    bool is_perspective = false;
};

struct MeshMeasures {
    std::size_t triangles = 0;
    std::vector<ViewMeasures> views;
    std::vector<DrawnView> worst_drawing;  ///< that of the least outline; one, or none
};

/// Of all views. Views in which nothing can be measured have unknown shares.
/// @throws laplacian_lines::Error for meshes that cannot be drawn.
MeshMeasures measure_drawing(const laplacian_lines::TriangleMesh& mesh,
                             const MeasureOptions& options);

/// Over the views of which a share is known.
struct Spread {
    double mean = 0, least = 0, most = 0;
    int least_view = -1;  ///< -1: no view is known

    bool is_known() const { return least_view >= 0; }
};
Spread spread(const MeshMeasures& mesh, Share ViewMeasures::*share);

}  // namespace benchmarks
