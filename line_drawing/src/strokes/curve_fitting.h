// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "line_drawing/path.h"

namespace line_drawing {

/// Adds cubic Bézier curves along `points` to `path`, beginning with moveTo(), so that no point is
/// farther from them than `tolerance`. Where the points turn sharply, the curve has a corner. A
/// closed line ends with a copy of its first point.
///
/// Source: P. J. Schneider, "An Algorithm for Automatically Fitting Digitized Curves", Graphics
/// Gems (1990).
void fitCurve(const std::vector<Eigen::Vector2d>& points, bool closed, double tolerance,
              Path& path);

/// Where `points` turn by more than 25° within `reach`; ends of open lines are none.
std::vector<std::size_t> findCorners(const std::vector<Eigen::Vector2d>& points, bool closed,
                                     double reach);

}  // namespace line_drawing
