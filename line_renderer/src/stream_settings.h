// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>

#include "line_renderer/line_renderer.h"
#include "line_stream.h"

namespace line_renderer {

/// From mesh to eye lengths, averaged over directions.
inline double meanScale(const Eigen::Matrix4d& to_eye) {
    return std::cbrt(std::abs(to_eye.topLeftCorner<3, 3>().determinant()));
}

LineRadii lineRadii(const LineAppearance& appearance, double pixel_scale);

/// How far lines of a look move towards the eye before the surface can hide them, eye coordinates.
double lineClearance(std::size_t look, const LinePlacement& placement);

/// `half_viewport` in pixels.
StreamSettings streamSettings(const LineAppearance& appearance, const LinePlacement& placement,
                              const Eigen::Vector2f& half_viewport);

}  // namespace line_renderer
