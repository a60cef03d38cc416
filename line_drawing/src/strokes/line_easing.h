// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "views/drawn_view.h"

namespace line_drawing {

/// Points at equal distances along a line, one a row.
using EvenPoints = Eigen::Matrix<double, Eigen::Dynamic, 2>;

/// The points moved so that the line bends least, Σ |x[i-1] - 2 x[i] + x[i+1]|², with each within
/// its own `reach` of where it was: an elastic line in a tube, which has no corners where it
/// touches the tube. A closed line's last point is followed by its first, of which it has no copy.
///
/// The quadratic problem with balls as constraints is solved by the alternating direction method
/// of multipliers: Boyd et al., "Distributed Optimization and Statistical Learning via the
/// Alternating Direction Method of Multipliers" (2011), section 5.2.
EvenPoints bendLeast(const EvenPoints& points, const std::vector<double>& reach, bool closed);

/// Takes the triangles' edges out of contours of curved surfaces: between points that are exact,
/// lines bend as little as they can, but stay within `reach` of where they were, on the sheet.
/// Lines that end at them follow. Afterwards all points of contours are exact.
void easeLines(std::vector<DrawnLine>& lines, double reach);

/// The same for inner lines as they are drawn, with what goes on as them, which stays.
void easeInnerLines(std::vector<DrawnLine>& lines, double reach);

}  // namespace line_drawing
