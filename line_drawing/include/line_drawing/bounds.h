// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "laplacian_lines/triangle_mesh.h"

namespace line_drawing {

/// Of the triangles' vertices that are finite.
Eigen::AlignedBox3d boundsOf(const laplacian_lines::TriangleMesh& mesh);

}  // namespace line_drawing
