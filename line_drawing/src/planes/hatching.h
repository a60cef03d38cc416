// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace line_drawing {

using Loops = std::vector<std::vector<Eigen::Vector2d>>;

/// Where the line in the unit direction `direction`, `offset` to the left of the origin (y up),
/// enters and leaves the area that loops enclose (even-odd): coordinates along it, ascending.
std::vector<double> crossings_at(const Loops& loops, const Eigen::Vector2d& direction,
                                 double offset);

/// Hatching lines of two points, `spacing` apart in the unit direction `direction`, within the
/// union of areas.
std::vector<std::vector<Eigen::Vector2d>> hatch(const std::vector<Loops>& areas,
                                                const Eigen::Vector2d& direction, double spacing);

}  // namespace line_drawing
