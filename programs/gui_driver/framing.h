// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace driver {

/// The part of a picture that points are to fill, as seen from an eye at a distance of 1.
struct Window {
    double half_width;
    double half_height;
};

/// How far from the origin, along z, an eye has to be to show all points within a window. In the
/// camera's coordinates: x to the right of the picture, y up, z to the viewer.
/// @param points not empty, finite, not all the same
/// @param window tangents of the angles from the middle of the picture to its sides
/// @param nearest all points are left at least so far from the eye, as a share of its z
double leastDistance(const std::vector<Eigen::Vector3d>& points, const Window& window,
                     double nearest);

/// The eye with this z, larger than that of any point, that has the points in the middle of its
/// picture.
Eigen::Vector3d centredEye(const std::vector<Eigen::Vector3d>& points, double z);

/// What a camera with parallel rays has to show for the same.
struct ParallelFrame {
    Eigen::Vector2d middle;  ///< of the picture
    double scale;            ///< of the window, whose sizes are lengths then; 0 for a single point
};
ParallelFrame parallelFrame(const std::vector<Eigen::Vector3d>& points, const Window& window);

}  // namespace driver
