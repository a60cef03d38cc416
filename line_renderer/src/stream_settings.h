// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_renderer/line_renderer.h"
#include "line_stream.h"

namespace line_renderer {

LineRadii lineRadii(const LineAppearance& appearance, double pixel_scale);

/// How far towards the eye lines of a look are moved before the surface can hide them, length in
/// eye coordinates.
double lineClearance(std::size_t look, const LinePlacement& placement);

/// How lines are written for this appearance and placement. `half_viewport` in pixels.
StreamSettings streamSettings(const LineAppearance& appearance, const LinePlacement& placement,
                              const Eigen::Vector2f& half_viewport);

}  // namespace line_renderer
