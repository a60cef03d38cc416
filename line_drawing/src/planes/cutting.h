// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace line_drawing {

/// A line in which a plane cuts a surface; it ends with a copy of its first point if it is closed.
using Cut = std::vector<Eigen::Vector3d>;

/// Where the plane at `height` along an axis of the mesh cuts it: closed lines of closed surfaces,
/// whose triangles may have vertices of their own as long as these are at the same places. In mesh
/// coordinates, in the order of the triangles.
std::vector<Cut> cutMesh(const laplacian_lines::TriangleMesh& mesh, int axis, double height);

using Loops = std::vector<std::vector<Eigen::Vector2d>>;

/// Where a straight line in the unit direction `direction`, `offset` to the left of the origin,
/// goes into what loops enclose (even-odd) and out of it: places along it, ascending.
std::vector<double> crossingsAt(const Loops& loops, const Eigen::Vector2d& direction,
                                double offset);

/// Lines of a distance of `spacing` in the unit direction `direction`, within areas or what several
/// of them cover together. Each has two points.
std::vector<std::vector<Eigen::Vector2d>> hatch(const std::vector<Loops>& areas,
                                                const Eigen::Vector2d& direction, double spacing);

}  // namespace line_drawing
