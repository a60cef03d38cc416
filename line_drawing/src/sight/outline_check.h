// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "views/drawn_view.h"
#include "views/projection.h"

namespace line_drawing {

/// Checks a view's outlines by independent means: fills its triangles in pixels of this size, mm of
/// the object. Returns the middles of border pixels without an outline within two pixels. `bounds`
/// are the surface's in the view.
std::vector<Eigen::Vector2d> borderWithoutOutline(const laplacian_lines::TriangleMesh& mesh,
                                                  const Projection& projection, double unit,
                                                  const Eigen::AlignedBox2d& bounds,
                                                  const std::vector<DrawnLine>& lines,
                                                  double pixel);

/// Segments within two pixels of these places, as outlines.
std::vector<DrawnLine> linesAt(const std::vector<Eigen::Vector2d>& places,
                               const std::vector<DrawnLine>& lines, double pixel);

}  // namespace line_drawing
