// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "views/drawn_view.h"

namespace line_drawing {

using EvenPoints = Eigen::Matrix<double, Eigen::Dynamic, 2>;

/// Moves points so that the line bends least, Σ |x[i-1] - 2 x[i] + x[i+1]|², each within its
/// `reach`: an elastic line in a tube, without corners where it touches. A closed line does not
/// repeat its first point. By the alternating direction method of multipliers: Boyd et al.,
/// "Distributed Optimization and Statistical Learning via the Alternating Direction Method of
/// Multipliers" (2011), section 5.2.
EvenPoints bendLeast(const EvenPoints& points, const std::vector<double>& reach, bool closed);

/// Smooths the triangles' edges out of contours of curved surfaces: between exact points lines bend
/// as little as they can within `reach`, on the sheet, and lines that end at them follow.
/// Afterwards all points of contours are eased.
void easeLines(std::vector<DrawnLine>& lines, double reach);

/// The same for inner lines as drawn; what continues them stays.
void easeInnerLines(std::vector<DrawnLine>& lines, double reach);

}  // namespace line_drawing
