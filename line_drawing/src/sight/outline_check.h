// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "views/drawn_view.h"
#include "views/projection.h"

namespace line_drawing {

/// Holds the outlines of a view against what the surface covers in its picture, filled triangle by
/// triangle in pixels of this size, mm of the object: by other means, so that an error of the one
/// is seen by the other. `bounds` are those of the surface in the view. Returns the middles of the
/// pixels at the border of what is covered that have no outline within two pixels.
std::vector<Eigen::Vector2d> borderWithoutOutline(const laplacian_lines::TriangleMesh& mesh,
                                                  const Projection& projection, double unit,
                                                  const Eigen::AlignedBox2d& bounds,
                                                  const std::vector<DrawnLine>& lines,
                                                  double pixel);

/// The segments of lines that pass within two pixels of such places, as outlines.
std::vector<DrawnLine> linesAt(const std::vector<Eigen::Vector2d>& places,
                               const std::vector<DrawnLine>& lines, double pixel);

}  // namespace line_drawing
