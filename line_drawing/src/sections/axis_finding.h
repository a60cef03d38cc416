// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/triangle_mesh.h"

namespace line_drawing {

/// A point on the axis around which a vessel was thrown, which points in the direction of the
/// mesh's axis `up`: the normals of a surface of revolution meet its axis. Handles and spouts, of
/// which fewer do, count little. In mesh coordinates; the point's own place along the axis is 0.
/// The middle of the bounding box where normals tell nothing.
///
/// Source: the linear complex of normals, H. Pottmann, T. Randrup, "Rotational and helical surface
/// approximation for reverse engineering", Computing 60 (1998), with iterated weights.
Eigen::Vector3d findAxis(const laplacian_lines::TriangleMesh& mesh, int up);

}  // namespace line_drawing
