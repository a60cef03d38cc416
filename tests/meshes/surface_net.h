// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "laplacian_lines/triangle_mesh.h"
#include "rounded_walls.h"

namespace test_meshes {

/// A closed mesh of a solid inside a box whose distance is exact or less: a vertex on the surface
/// for each cell of a grid that it passes through, a quadrangle, cut along its shorter diagonal,
/// for each edge of the grid that it cuts. The solid has to be thicker than two cells, and so have
/// the gaps in it. The grid is turned against the axes, so that plane faces do not lie along it.
laplacian_lines::TriangleMesh surface_net(const Solid& solid, const Eigen::AlignedBox3d& box,
                                          double cell);

}  // namespace test_meshes
