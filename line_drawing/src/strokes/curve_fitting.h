// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "line_drawing/path.h"

namespace line_drawing {

/// Appends cubic Bézier curves to `path`, after a moveTo(), that pass within `tolerance` of all
/// points, with corners where the points turn sharply. A closed line repeats its first point. P. J.
/// Schneider, "An Algorithm for Automatically Fitting Digitized Curves", Graphics Gems (1990).
void fitCurve(const std::vector<Eigen::Vector2d>& points, bool closed, double tolerance,
              Path& path);

}  // namespace line_drawing
