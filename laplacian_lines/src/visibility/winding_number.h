// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "visibility/sight_mesh.h"

namespace laplacian_lines {

/// The sum of the solid angles of all triangles at a point, local, over 4π; +1 inside a closed
/// surface that faces outwards.
double winding_number(const SightMesh& mesh, const Eigen::Vector3d& point);

}  // namespace laplacian_lines
