// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace driver {

/// What points should fill of a picture, seen from a distance of 1.
struct Window {
    double half_width;
    double half_height;
};

/// How far along z from the origin an eye has to be to show all points within a window, in camera
/// coordinates: x right, y up, z to the viewer.
/// @param points not empty, finite, not all the same
/// @param window tangents of the angles from the picture's middle to its sides
/// @param nearest least distance of points from the eye, as a share of its z
double leastDistance(const std::vector<Eigen::Vector3d>& points, const Window& window,
                     double nearest);

/// The eye with this z, beyond all points, that centres them in its picture.
Eigen::Vector3d centredEye(const std::vector<Eigen::Vector3d>& points, double z);

/// For a camera with parallel rays.
struct ParallelFrame {
    Eigen::Vector2d middle;  ///< of the picture
    double scale;            ///< of the window, whose sizes are lengths then; 0 for a single point
};
ParallelFrame parallelFrame(const std::vector<Eigen::Vector3d>& points, const Window& window);

}  // namespace driver
