// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "line_drawing/section.h"

namespace line_drawing {

/// Where a section's plane is, in coordinates of the mesh, whose bounding box is `box`.
inline double placeOnAxis(const Section& section, const Eigen::AlignedBox3d& box) {
    return box.min()[section.axis] + section.share * box.sizes()[section.axis];
}

}  // namespace line_drawing
