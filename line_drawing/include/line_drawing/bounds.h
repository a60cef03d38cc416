// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "laplacian_lines/triangle_mesh.h"

namespace line_drawing {

/// The part of the mesh that has triangles; vertices that are not finite do not count.
Eigen::AlignedBox3d boundsOf(const laplacian_lines::TriangleMesh& mesh);

}  // namespace line_drawing
