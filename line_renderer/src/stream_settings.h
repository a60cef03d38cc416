// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>

#include "line_renderer/line_renderer.h"
#include "line_stream.h"

namespace line_renderer {

/// Length in eye coordinates of a length in mesh coordinates, the mean over directions if the
/// layer's transformation scales them differently.
inline double meanScale(const Eigen::Matrix4d& to_eye) {
    return std::cbrt(std::abs(to_eye.topLeftCorner<3, 3>().determinant()));
}

LineRadii lineRadii(const LineAppearance& appearance, double pixel_scale);

/// How far towards the eye lines of a look are moved before the surface can hide them, length in
/// eye coordinates.
double lineClearance(std::size_t look, const LinePlacement& placement);

/// How lines are written for this appearance and placement. `half_viewport` in pixels.
StreamSettings streamSettings(const LineAppearance& appearance, const LinePlacement& placement,
                              const Eigen::Vector2f& half_viewport);

}  // namespace line_renderer
