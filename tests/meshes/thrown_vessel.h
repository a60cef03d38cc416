// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace test_meshes {

struct VesselShape {
    int rings = 600, columns = 720;
    double relief = 1;  ///< height of grooves, wave and traces of throwing; 0: smooth
};

/// From the underside's middle around the wall to the inside's middle: (radius, height), mm, evenly
/// spaced.
std::vector<Eigen::Vector2d> vessel_profile(int points);

/// A jar of 200 mm around the y axis: closed, walls of 4 to 8 mm, two grooves and an incised wave
/// on the shoulder, throwing marks inside.
laplacian_lines::TriangleMesh thrown_vessel(const VesselShape& shape = {});

}  // namespace test_meshes
