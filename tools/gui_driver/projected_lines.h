// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace driver {

/// Whether the depth buffer leaves a point of a line to be seen. Points within the plugin's depth
/// tolerance of a surface may be drawn or not.
enum class Sight { Visible, Unsure, Hidden };

struct ProjectedSample {
    Eigen::Vector2d pixel;  ///< from the upper left corner of the view
    Sight sight;
};

/// The lines of one layer on the screen, sampled at every half pixel.
struct ProjectedLines {
    std::vector<ProjectedSample> samples;
    int lines = 0;
};

}  // namespace driver
